// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// Forces (n x 1) that make the tree accelerate so (n x 1), per element of the velocity: at joints
/// Nm or N, at a floating base N in the world's axes and Nm in those of the velocity. Nothing else
/// acts but gravity; other forces are subtracted by the caller (add_point_force()). Recursive
/// Newton-Euler, docs/derivations/rigid_body.md eqs. (4)-(8).
template <typename T>
void inverse_dynamics(TreeStateOf<T>& state, const VectorInOf<T>& acceleration,
                      VectorOutOf<T> force);

/// The forces (n x 1) that hold accelerations at zero: Coriolis, centrifugal, gravity; eqs. (4)-(8)
/// with q'' = 0.
template <typename T>
void bias(TreeStateOf<T>& state, VectorOutOf<T> force);

}  // namespace torquewright::dynamics
