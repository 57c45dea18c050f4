// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "robot/mechanisms/loop.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Whether the drivetrain's actuators push: their torques are forces in N, then, and their angles
/// ways in m. In a loop the joints are asked that they turn or push, else those that it moves.
inline bool moves_slide(const Robot& robot, const Drivetrain& drivetrain) {
  if (const auto* loop = dynamic_cast<const Loop*>(drivetrain.mechanism.get())) {
    const std::vector<std::size_t>& turned = loop->geometry().turned;
    return std::any_of(turned.begin(), turned.end(), [&](std::size_t body) {
      return loop->geometry().tree.bodies[body].joint.kind == dynamics::JointKind::kPrismatic;
    });
  }
  return std::any_of(drivetrain.joints.begin(), drivetrain.joints.end(), [&](std::size_t body) {
    return robot.tree.bodies[body].joint.kind == dynamics::JointKind::kPrismatic;
  });
}

}  // namespace torquewright::hopper
