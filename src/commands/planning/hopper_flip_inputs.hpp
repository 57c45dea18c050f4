// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hopper/planning/search/plan.hpp"
#include "robot/model/robot_spec.hpp"
#include "src/options/hopper_flip_request.hpp"

namespace torquewright::cli {

/// What was read for a plan.
struct HopperFlipInputs {
  hopper::ReadRobot robot;
  std::vector<io::Document> columns;     ///< Of kind trajectory_columns.
  std::unique_ptr<hopper::Motion> warm;  ///< Null: none was named.
  hopper::PlanOptions plan;              ///< Points to `warm`.
};

/// Reads all documents and the motion to begin from. Throws io::SpecError.
HopperFlipInputs read_flip_inputs(const HopperFlipRequest& request);

/// The margins that the plan's reserve makes, with those that the request states by themselves.
/// Throws io::SpecError where the reserve is too great.
void set_margins(const HopperFlipRequest& request, hopper::PlanOptions& plan);

}  // namespace torquewright::cli
