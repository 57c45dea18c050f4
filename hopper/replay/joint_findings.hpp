// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/demand/checked_motion.hpp"
#include "hopper/record/record.hpp"

namespace torquewright::hopper {

/// Where a run's joints go beyond the speed and the torque that the robot's document states of
/// them, by the rules of `hopper check`; the torque is that of the drives, carried to the joint.
/// Ranges are not looked at: the joints' stops hold them.
std::vector<Finding> joint_findings(const Robot& robot, const Record& record);

}  // namespace torquewright::hopper
