// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// What each drive's motor gives at its output at the peak current, gears' loss and limit counted,
/// saturation not: a scale (drives x 1), in the order of the drivetrains.
Eigen::VectorXd peak_torques_Nm(const Robot& robot);

}  // namespace torquewright::hopper
