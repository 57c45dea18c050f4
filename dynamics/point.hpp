// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// A point fixed to a body, in the body's frame.
struct BodyPoint {
  std::size_t body = 0;
  Eigen::Vector3d p_B_m = Eigen::Vector3d::Zero();
};

/// Position, velocity and acceleration of a point in the world's axes;
/// docs/derivations/rigid_body.md eqs. (17)-(19).
template <typename T>
Vector3<T> point_position_m(const TreeStateOf<T>& state, const BodyPoint& point);
template <typename T>
Vector3<T> point_velocity_m_s(const TreeStateOf<T>& state, const BodyPoint& point);
/// Writes the point's Jacobian (3 x n): its velocity per velocity of the tree.
template <typename T>
void point_jacobian(const TreeStateOf<T>& state, const BodyPoint& point, JacobianOf<T> out);
/// Writes the rotation Jacobian (3 x n): angular velocity of the body per velocity of the tree.
template <typename T>
void rotation_jacobian(const TreeStateOf<T>& state, std::size_t body, JacobianOf<T> out);
/// Returns the point's acceleration while the tree's is zero: d/dt of its Jacobian times the
/// velocity.
template <typename T>
Vector3<T> point_bias_acceleration_m_s2(const TreeStateOf<T>& state, const BodyPoint& point);
/// Adds J^T force (n x 1): the effect on the tree of a force on the point, in the world's axes.
template <typename T>
void add_point_force(const TreeStateOf<T>& state, const BodyPoint& point,
                     const Vector3In<T>& force_N, VectorOutOf<T> force);

}  // namespace torquewright::dynamics
