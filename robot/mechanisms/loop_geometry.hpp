// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "dynamics/point.hpp"

namespace torquewright::hopper {

/// Two points of a loop's bodies that stay together.
using LoopClosure = std::array<dynamics::BodyPoint, 2>;

/// Bodies between a ground and the robot's own joints, with what closes them to loops.
struct LoopGeometry {
  /// The ground, at rest and without mass; what the robot's own joints carry, without mass, for the
  /// robot has them; then the links, with theirs.
  dynamics::Tree tree;
  Eigen::Index joints = 1;  ///< The robot's own: bodies 1 to this of the tree.
  std::vector<LoopClosure> closures;
  /// The joints that the actuators turn or push, by the body of the tree that each carries. Empty:
  /// none does, and the links only follow.
  std::vector<std::size_t> turned;
  /// Positions of all joints of the tree in a posture in which they nearly close.
  Eigen::VectorXd start;

  Eigen::Index links() const { return static_cast<Eigen::Index>(tree.bodies.size()) - 1 - joints; }
};

}  // namespace torquewright::hopper
