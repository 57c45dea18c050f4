// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// Motion of a body per unit of one velocity: its angular velocity, and the velocity of the point
/// at the base's origin as if it belonged to the body. World's axes.
template <typename T>
struct ColumnOf {
  Vector3<T> angular;
  Vector3<T> linear;
};
using Column = ColumnOf<double>;

/// Returns the motion of a body per unit of its joint's velocity; eq. (9).
template <typename T>
inline ColumnOf<T> joint_column(const TreeStateOf<T>& state, std::size_t body) {
  const BodyMotionOf<T>& motion = state.motion(body);
  if (state.tree().bodies[body].joint.kind == JointKind::kPrismatic) {
    return {Vector3<T>::Zero(), motion.axis};
  }
  return {motion.axis, motion.origin_m.cross(motion.axis)};
}

/// Returns the motion of the base per unit of its velocity number k, k < base_velocity_size().
template <typename T>
inline ColumnOf<T> base_column(const TreeStateOf<T>& state, Eigen::Index k) {
  const Vector3<T> zero = Vector3<T>::Zero();
  if (state.tree().base == BaseKind::kPlanar) {
    if (k == 2) return {Vector3<T>::UnitY(), zero};
    return {zero, k == 0 ? Vector3<T>::UnitX() : Vector3<T>::UnitZ()};
  }
  if (k < 3) return {zero, Vector3<T>::Unit(k)};
  return {state.motion(0).R_WB.col(k - 3), zero};
}

}  // namespace torquewright::dynamics
