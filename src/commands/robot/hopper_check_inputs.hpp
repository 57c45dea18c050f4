// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/candidates/candidate_set.hpp"
#include "hopper/demand/checked_motion.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "robot/model/robot_spec.hpp"
#include "src/options/hopper_check_request.hpp"

namespace torquewright::cli {

/// What was read for a whole-body check beside the motion.
struct HopperCheckInputs {
  hopper::ReadRobot robot;
  std::vector<io::Document> columns;  ///< Of kind trajectory_columns.
  hopper::CheckOptions check;
  hopper::CandidateSet candidates;  ///< Empty where no folder of them was given.
};

/// The motion stands apart: the check adds the rates that it lacks where it stands, since a copy of
/// a long one would take as much memory again.
struct HopperCheckRead {
  HopperCheckInputs inputs;
  hopper::Motion motion;
};

/// Where the motion lies and what its columns are. Reads their documents.
hopper::MotionFile motion_file(const HopperCheckRequest& request);
/// The motion, with progress on a terminal.
hopper::Motion motion_in(hopper::MotionFile source, const hopper::Robot& robot);
/// Throws io::SpecError where an actuator cannot be under the conditions that are asked for.
hopper::CheckOptions check_options(const HopperCheckRequest& request,
                                   const hopper::ReadRobot& read);

/// Reads all documents and the motion. Throws io::SpecError.
HopperCheckRead read_inputs(const HopperCheckRequest& request);

}  // namespace torquewright::cli
