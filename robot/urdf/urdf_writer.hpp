// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A robot in another format, and what that cannot hold, in sentences (which stand in the file
/// too).
struct Exported {
  std::string text;
  std::vector<std::string> notes;
};

/// Drives that stand in the joints of what is written (simulators/drives_in_joints.hpp), and what
/// was said of it.
struct DrivesInJoints {
  bool are_there = false;
  std::vector<std::string> notes;
  std::vector<std::string> of_actuators;  ///< What each one's file says, for the head of this one.
};

Exported urdf_of(const Robot& robot, const DrivesInJoints& drives = {});

}  // namespace torquewright::hopper
