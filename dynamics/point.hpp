// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// A point fixed to a body, in the body's frame.
struct BodyPoint {
  std::size_t body = 0;
  Eigen::Vector3d p_B_m = Eigen::Vector3d::Zero();
};

/// All in the world's axes; docs/derivations/rigid_body.md eqs. (17)-(19).
Eigen::Vector3d point_position_m(const TreeState& state, const BodyPoint& point);
Eigen::Vector3d point_velocity_m_s(const TreeState& state, const BodyPoint& point);
/// (3 x n): velocity of the point per velocity of the tree.
void point_jacobian(const TreeState& state, const BodyPoint& point, Jacobian out);
/// (3 x n): angular velocity of the body per velocity of the tree.
void rotation_jacobian(const TreeState& state, std::size_t body, Jacobian out);
/// The point's acceleration while the tree's is zero: d/dt of its Jacobian times the velocity.
Eigen::Vector3d point_bias_acceleration_m_s2(const TreeState& state, const BodyPoint& point);
/// Adds J^T force (n x 1): what the tree feels of a force of the world's on the point.
void add_point_force(const TreeState& state, const BodyPoint& point, const Eigen::Vector3d& force_N,
                     VectorOut force);

}  // namespace torquewright::dynamics
