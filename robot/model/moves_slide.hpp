// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Whether the drivetrain moves a joint that slides: its actuators' torques are forces in N, then,
/// and their angles ways in m.
inline bool moves_slide(const Robot& robot, const Drivetrain& drivetrain) {
  return std::any_of(drivetrain.joints.begin(), drivetrain.joints.end(), [&](std::size_t body) {
    return robot.tree.bodies[body].joint.kind == dynamics::JointKind::kPrismatic;
  });
}

}  // namespace torquewright::hopper
