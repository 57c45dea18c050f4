// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::hopper {

/// R = Rz(yaw) Ry(pitch) Rx(roll), as URDF and our documents have it.
Eigen::Matrix3d rotation_of_rpy(const Eigen::Vector3d& rpy_rad);

/// The inverse; where pitch is +-90 degrees, roll is 0 but for roundings.
Eigen::Vector3d rpy_of_rotation(const Eigen::Matrix3d& R);

}  // namespace torquewright::hopper
