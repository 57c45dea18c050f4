// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include "dynamics/jet.hpp"
#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// Returns a vector whose elements are the variables first, first + 1, ...; requires room for them
/// (kMostVariables).
template <typename T>
VectorX<T> seeded(const VectorIn& values, int first) {
  VectorX<T> out(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    out[i] = T::variable(values[i], first + static_cast<int>(i));
  }
  return out;
}

/// Returns the position (position_size x 1) to which a small displacement (n x 1) leads, as
/// step_position() counts it: a spatial base turns about its own axes. Equal to second order, which
/// is all that derivatives at zero see; docs/derivations/jets.md eq. (4). Requires a quaternion
/// that is not zero.
template <typename T>
VectorX<T> displaced(const Tree& tree, const VectorIn& position, const VectorInOf<T>& by) {
  if (tree.base != BaseKind::kSpatial) return position + by;
  const Eigen::Index joints = by.size() - 6;
  VectorX<T> out(position.size());
  out.head(3) = position.head(3) + by.head(3);
  out.tail(joints) = position.tail(joints) + by.tail(joints);
  const Eigen::Vector4d at = position.segment<4>(3).normalized();
  const Eigen::Vector3d u = at.tail<3>();
  const Vector3<T> turn_rad = by.template segment<3>(3);
  const Vector3<T> v = 0.5 * turn_rad;
  const T w = 1.0 - 0.5 * v.dot(v);
  out[3] = at[0] * w - v.dot(u);
  out.template segment<3>(4) = at[0] * v + w * u - v.cross(u);
  return out;
}

/// Returns the same position with the variables first .. first + n - 1 as displacements from it.
template <typename T>
VectorX<T> seeded_position(const Tree& tree, const VectorIn& position, int first) {
  return displaced<T>(tree, position,
                      seeded<T>(Eigen::VectorXd::Zero(tree.velocity_size()), first));
}

}  // namespace torquewright::dynamics
