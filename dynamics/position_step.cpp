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

Eigen::Quaterniond base_turn(const VectorIn& position) {
  return Eigen::Quaterniond(position[3], position[4], position[5], position[6]).normalized();
}

/// By the sine of half the angle, which is exact for small ones as AngleAxis's arc cosine is not.
Eigen::Vector3d rotation_rad(const Eigen::Quaterniond& turn) {
  const double sine = turn.vec().norm();
  if (!(sine > 0)) return Eigen::Vector3d::Zero();
  const double half_rad = std::atan2(sine, std::abs(turn.w()));
  return std::copysign(2.0 * half_rad / sine, turn.w()) * turn.vec();
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
  const Eigen::Quaterniond after =
      (base_turn(position) * turn(duration_s * velocity.segment<3>(3))).normalized();
  const Eigen::Index joints = velocity.size() - 6;
  out.head<3>() = position.head<3>() + duration_s * velocity.head<3>();
  out.segment<4>(3) << after.w(), after.x(), after.y(), after.z();
  out.tail(joints) = position.tail(joints) + duration_s * velocity.tail(joints);
}

void position_difference(const Tree& tree, const VectorIn& from, const VectorIn& to,
                         VectorOut out) {
  if (from.size() != tree.position_size() || to.size() != tree.position_size() ||
      out.size() != tree.velocity_size()) {
    throw std::invalid_argument("position difference: wrong number of positions or velocities");
  }
  if (tree.base != BaseKind::kSpatial) {
    out = to - from;
    return;
  }
  const Eigen::Index joints = out.size() - 6;
  out.head<3>() = to.head<3>() - from.head<3>();
  out.segment<3>(3) = rotation_rad(base_turn(from).conjugate() * base_turn(to));
  out.tail(joints) = to.tail(joints) - from.tail(joints);
}

// docs/derivations/time_stepping.md eq. (2)
void step_rate(const Tree& tree, const VectorIn& step, const VectorIn& velocity, VectorOut out) {
  if (step.size() != tree.velocity_size() || velocity.size() != tree.velocity_size() ||
      out.size() != tree.velocity_size()) {
    throw std::invalid_argument("step rate: wrong number of velocities");
  }
  out = velocity;
  if (tree.base != BaseKind::kSpatial) return;
  const Eigen::Vector3d turn_rad = step.segment<3>(3);
  const Eigen::Vector3d across = turn_rad.cross(velocity.segment<3>(3));
  out.segment<3>(3) += 0.5 * across + turn_rad.cross(across) / 12.0;
}

}  // namespace torquewright::dynamics
