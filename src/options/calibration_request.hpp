// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/calibration/figures.hpp"
#include "src/command_line/command_line.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::cli {

/// What `hopper calibrate` is to bring about, in the words of the command line.
struct CalibrationRequest {
  std::vector<std::string> targets;   ///< cam=6.0; cav=7.4:10.6 (takeoff, tuck); cav@NAME=7.4
  std::vector<std::string> free;      ///< POINTER[,POINTER...][=LOW:HIGH]
  std::vector<std::string> postures;  ///< NAME=JOINT:POSITION,...
  double tolerance = 0.01;
};

/// Adds --target, --free, --posture and --tolerance.
void add_calibration_options(command_line::Command& command, CalibrationRequest& request);

/// Writes the postures of the command line into the robot's document, over those it has. Throws
/// io::SpecError for what does not read as one.
void add_postures(const CalibrationRequest& request, io::Document& robot);

/// Throws io::SpecError: targets that do not read, no CAM or no CAV, postures that the robot does
/// not have, a fixed base (no flight), no or twofold free values.
hopper::calibration::Question calibration_question(const CalibrationRequest& request,
                                                   const io::Document& document,
                                                   const hopper::Robot& robot);

}  // namespace torquewright::cli
