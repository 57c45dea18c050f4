// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Postures of the drivetrain's joints (k x 1) all over their ranges, in equal steps; where a joint
/// has no range, a radian either way of the posture nearest to zero.
std::vector<SmallVector> postures_in_range(const dynamics::Tree& tree,
                                           const Drivetrain& drivetrain);

}  // namespace torquewright::hopper
