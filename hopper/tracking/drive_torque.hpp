// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Returns the torque of each drive at its output at the peak current, with the gears' loss and
/// limit and without saturation: a scale (drives x 1), in the order of the drivetrains.
Eigen::VectorXd peak_torques_Nm(const Robot& robot);

}  // namespace torquewright::hopper
