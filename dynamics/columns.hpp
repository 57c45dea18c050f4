// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// What one unit of one velocity does to all that it moves: a turn, and a speed of the point at the
/// base's origin as if it belonged to them. World's axes.
struct Column {
  Eigen::Vector3d angular;
  Eigen::Vector3d linear;
};

/// Of a body's joint; eq. (9).
inline Column joint_column(const TreeState& state, std::size_t body) {
  const BodyMotion& motion = state.motion(body);
  if (state.tree().bodies[body].joint.kind == JointKind::kPrismatic) {
    return {Eigen::Vector3d::Zero(), motion.axis};
  }
  return {motion.axis, motion.origin_m.cross(motion.axis)};
}

/// Of the base's velocity number k, k < base_velocity_size().
inline Column base_column(const TreeState& state, Eigen::Index k) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  if (state.tree().base == BaseKind::kPlanar) {
    if (k == 2) return {Eigen::Vector3d::UnitY(), zero};
    return {zero, k == 0 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ()};
  }
  if (k < 3) return {zero, Eigen::Vector3d::Unit(k)};
  return {state.motion(0).R_WB.col(k - 3), zero};
}

}  // namespace torquewright::dynamics
