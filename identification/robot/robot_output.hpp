// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "identification/rig/joint_controller.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::identification {

/// A robot whose joints hold the values that its own log gave, with the controllers that moved it.
struct RobotSubject {
  hopper::Robot robot;
  std::vector<std::size_t> bodies;           ///< That each logged joint carries.
  std::vector<JointController> controllers;  ///< In the same order.
  std::vector<std::string> origin;           ///< Sentences that head the file.
};

/// A simulator's file of such a robot: one entry in robot_outputs.cpp.
struct RobotOutput {
  std::string_view name;    ///< Name as in --as.
  std::string_view what;    ///< Description for the help.
  std::string_view source;  ///< Where its fields are documented.
  std::string (*write)(const RobotSubject& subject);
};

std::span<const RobotOutput> robot_outputs();

/// Null where no output of robots has the name.
const RobotOutput* find_robot_output(std::string_view name);

}  // namespace torquewright::identification
