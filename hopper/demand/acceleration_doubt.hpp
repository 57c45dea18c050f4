// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/checked_motion.hpp"

namespace torquewright::hopper {

/// Returns (drives x samples), Nm: the most by which torques of the dynamics are off where every
/// acceleration is by as much as the motion's acceleration_doubt, either way. Contact forces of
/// points that may press follow, by the least that moves the free rows alike, their cones aside.
/// Zero where the motion has no such doubt.
Eigen::MatrixXd torques_of_acceleration_doubt(const CheckedMotion& checked);

}  // namespace torquewright::hopper
