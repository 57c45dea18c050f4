// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// By joint, whether its measured position changes by more than an encoder's step in any run. Of
/// what does not move, nothing is judged; joints without positions, and those of other loads than a
/// robot, count as moving.
std::vector<bool> moving_joints(const Rig& rig, const Log& log);

/// Says which joints of a robot never move, and refuses commands that are the positions in degrees:
/// io::SpecError.
void check_robot_motion(const Rig& rig, Log& log);

}  // namespace torquewright::identification
