// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/experiment/plan.hpp"
#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// What `identify plan` is asked.
struct PlanRequest {
  std::string actuator, rig, excitation;
  std::vector<std::string> noise;
  identification::PlanOptions options;
  std::string robot;                   ///< Where the rig states no load.
  std::vector<std::string> of_joints;  ///< JOINT=FILE, of a robot.
  std::string posture;
  std::optional<double> base_height_m;
  const command_line::DeclaredCommand* declared = nullptr;
  bool json = false;
};

/// Plans what the joints of the rig's robot are to be told.
ExitCode run_robot_plan(const PlanRequest& request);

}  // namespace torquewright::cli
