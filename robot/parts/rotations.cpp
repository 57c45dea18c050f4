// SPDX-License-Identifier: Apache-2.0
#include "robot/parts/rotations.hpp"

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
  const double level = std::hypot(R(0, 0), R(1, 0));
  const double yaw_rad =
      level < kUpright ? std::atan2(-R(0, 1), R(1, 1)) : std::atan2(R(1, 0), R(0, 0));
  // Pitch and roll of what is left without that yaw, which is all but unknown near the upright:
  // whatever it is, these are what completes it.
  const double c = std::cos(yaw_rad);
  const double s = std::sin(yaw_rad);
  const double pitch_rad = std::atan2(-R(2, 0), c * R(0, 0) + s * R(1, 0));
  const double roll_rad = std::atan2(s * R(0, 2) - c * R(1, 2), c * R(1, 1) - s * R(0, 1));
  return {roll_rad, pitch_rad, yaw_rad};
}

}  // namespace torquewright::hopper
