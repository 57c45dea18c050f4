// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/turn.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "dynamics/position_step.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kLeastTurn_rad = 0.1;  ///< Less has no axis of its own.

/// The base's rotation from one position to the next, in the world's axes.
Vector3d turn_rad(const dynamics::Tree& tree, const VectorXd& from, const VectorXd& to) {
  if (tree.base == dynamics::BaseKind::kFixed) return Vector3d::Zero();
  if (tree.base == dynamics::BaseKind::kPlanar) return (to[2] - from[2]) * Vector3d::UnitY();
  VectorXd way(tree.velocity_size());
  dynamics::position_difference(tree, from, to, way);
  return base_attitude(tree, from) * way.segment<3>(3);
}

}  // namespace

Eigen::Matrix3d base_attitude(const dynamics::Tree& tree, const VectorXd& position) {
  if (tree.base != dynamics::BaseKind::kSpatial) {
    const double pitch = tree.base == dynamics::BaseKind::kPlanar ? position[2] : 0.0;
    return Eigen::AngleAxisd(pitch, Vector3d::UnitY()).toRotationMatrix();
  }
  return Eigen::Quaterniond(position[3], position[4], position[5], position[6])
      .normalized()
      .toRotationMatrix();
}

AttitudeError attitude_error(const dynamics::Tree& tree, const VectorXd& wanted,
                             const VectorXd& position) {
  const Eigen::Quaterniond off(base_attitude(tree, position) *
                               base_attitude(tree, wanted).transpose());
  // A turn about an axis on the ground, then one about the vertical: the former is the lean.
  return {2.0 * std::atan2(std::hypot(off.x(), off.y()), std::hypot(off.z(), off.w())),
          2.0 * std::atan2(off.w() < 0.0 ? -off.z() : off.z(), std::abs(off.w()))};
}

Vector3d planned_turn_rad(const dynamics::Tree& tree, const Reference& reference, double period_s,
                          double until_s) {
  Vector3d sum = Vector3d::Zero();
  ReferenceInstant before, after;
  reference.at(reference.begins_s(), before);
  const auto steps = static_cast<int>(std::ceil((until_s - reference.begins_s()) / period_s));
  for (int i = 1; i <= steps; ++i) {
    reference.at(std::min(until_s, reference.begins_s() + i * period_s), after);
    sum += turn_rad(tree, before.position, after.position);
    std::swap(before, after);
  }
  return sum;
}

Vector3d turned_rad(const dynamics::Tree& tree, const Record& record, double until_s) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 1; i < record.rows.size() && record.rows[i].time_s <= until_s; ++i) {
    sum += turn_rad(tree, record.rows[i - 1].position, record.rows[i].position);
  }
  return sum;
}

Vector3d axis_of_turn(const Vector3d& planned_rad) {
  return planned_rad.norm() > kLeastTurn_rad ? planned_rad.normalized()
                                             : Vector3d(Vector3d::UnitY());
}

}  // namespace torquewright::hopper
