// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Two bodies that a ball joint holds together.
struct LoopPin {
  std::size_t rod = 0;  ///< A body of the tree.
  std::size_t held = 0;
  Eigen::Vector3d p_R_m = Eigen::Vector3d::Zero();  ///< In the rod's frame.
};

/// A robot whose four-bars and parallel ankles are bodies: cranks that carry the rotors, rods, and
/// the pins that close their loops. Its drives turn the cranks.
struct LoopedRobot {
  Robot robot;
  /// They hold where all joints, cranks' and rods' too, are at their references.
  std::vector<LoopPin> pins;
  /// By body, of its joint: where it stands in the posture that the tree's frames show. Not zero
  /// where a loop's joint cannot stand at zero: such a tree is for a file with `ref` alone.
  std::vector<double> references;
};

/// Cranks and rods follow the robot's own bodies. They weigh next to nothing, which a note says; a
/// crank's position is its drive's less that where all joints are at zero. A linkage that does not
/// reach that posture stays as it is, and a note says so.
LoopedRobot with_closed_loops(const Robot& robot, std::vector<std::string>& notes);

}  // namespace torquewright::hopper
