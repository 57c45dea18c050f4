// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/calibration/figures.hpp"
#include "robot/model/robot_spec.hpp"
#include "src/options/calibration_request.hpp"

namespace torquewright::cli {

struct CalibrationInputs {
  hopper::ReadRobot robot;  ///< With the postures of the command line, over those it has.
  hopper::calibration::Question question;
};

/// Reads the robot and what is asked of it. Throws io::SpecError: what cannot be read, outputs that
/// could not be written, postures and targets that do not read, no CAM or no CAV, postures that the
/// robot does not have, a fixed base (no flight), no or twofold free values.
CalibrationInputs read_inputs(const CalibrationRequest& request);

}  // namespace torquewright::cli
