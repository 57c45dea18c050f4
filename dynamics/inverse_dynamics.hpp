// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// Computes the forces (n x 1) that give the tree these accelerations (n x 1): at joints Nm or N,
/// at a floating base N in the world's axes and Nm in those of the velocity. Nothing else acts but
/// gravity; the caller subtracts other forces (add_point_force()). Recursive Newton-Euler,
/// docs/derivations/rigid_body.md eqs. (4)-(8).
template <typename T>
void inverse_dynamics(TreeStateOf<T>& state, const VectorInOf<T>& acceleration,
                      VectorOutOf<T> force);

/// Computes the forces (n x 1) that hold accelerations at zero: Coriolis, centrifugal, gravity;
/// eqs. (4)-(8) with q'' = 0.
template <typename T>
void bias(TreeStateOf<T>& state, VectorOutOf<T> force);

}  // namespace torquewright::dynamics
