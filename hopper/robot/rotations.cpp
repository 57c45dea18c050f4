// SPDX-License-Identifier: Apache-2.0
#include "hopper/robot/rotations.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace torquewright::hopper {
namespace {
constexpr double kUpright = 1e-12;  // cosine of a pitch that leaves roll and yaw one turn
}

Eigen::Matrix3d rotation_of_rpy(const Eigen::Vector3d& rpy_rad) {
  return (Eigen::AngleAxisd(rpy_rad[2], Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy_rad[1], Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy_rad[0], Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Vector3d rpy_of_rotation(const Eigen::Matrix3d& R) {
  const double cosine = std::hypot(R(0, 0), R(1, 0));
  const double pitch_rad = std::atan2(0 - R(2, 0), cosine);
  if (cosine < kUpright) return {0, pitch_rad, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch_rad, std::atan2(R(1, 0), R(0, 0))};
}

}  // namespace torquewright::hopper
