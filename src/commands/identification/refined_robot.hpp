// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/files/atomic_file.hpp"
#include "robot/model/robot.hpp"
#include "src/commands/identification/identify_inputs.hpp"
#include "src/report/identification/robot_report.hpp"

namespace torquewright::cli {

/// A robot with what its log gave, in documents.
struct RefinedRobot {
  std::vector<io::FileContent> files;  ///< For the folder of --refined; empty where none is asked.
  hopper::Robot robot;                 ///< Its document as read back.
  std::vector<identification::JointController> controllers;
  std::vector<std::string> origin;  ///< What heads a simulator's file.
};

/// Writes the robot's document, and with --refined FOLDER an actuator for each group of alike
/// joints, reads them back and judges them on the log: their errors stand in `report.written`.
/// Nothing where neither a folder nor a simulator's file of a robot was asked for, or no value was
/// fitted.
std::optional<RefinedRobot> refined_robot(const IdentifyRequest& request,
                                          const IdentifyInputs& inputs,
                                          const identification::Identification& found,
                                          report::RobotReport& report);

/// What --as NAME prints of it.
std::string robot_output_text(const std::string& name, const IdentifyInputs& inputs,
                              const RefinedRobot& refined);

}  // namespace torquewright::cli
