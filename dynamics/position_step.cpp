// SPDX-License-Identifier: Apache-2.0
#include "dynamics/position_step.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

namespace torquewright::dynamics {
namespace {

Eigen::Quaterniond turn(const Eigen::Vector3d& rotation_rad) {
  const double angle_rad = rotation_rad.norm();
  if (!(angle_rad > 0)) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, rotation_rad / angle_rad));
}

}  // namespace

void step_position(const Tree& tree, const VectorIn& position, const VectorIn& velocity,
                   double duration_s, VectorOut out) {
  if (position.size() != tree.position_size() || out.size() != tree.position_size() ||
      velocity.size() != tree.velocity_size()) {
    throw std::invalid_argument("position step: wrong number of positions or velocities");
  }
  if (tree.base != BaseKind::kSpatial) {
    out = position + duration_s * velocity;
    return;
  }
  const Eigen::Quaterniond before =
      Eigen::Quaterniond(position[3], position[4], position[5], position[6]).normalized();
  const Eigen::Quaterniond after =
      (before * turn(duration_s * velocity.segment<3>(3))).normalized();
  const Eigen::Index joints = velocity.size() - 6;
  out.head<3>() = position.head<3>() + duration_s * velocity.head<3>();
  out.segment<4>(3) << after.w(), after.x(), after.y(), after.z();
  out.tail(joints) = position.tail(joints) + duration_s * velocity.tail(joints);
}

}  // namespace torquewright::dynamics
