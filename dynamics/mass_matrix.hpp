// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// Writes the mass matrix M (n x n), symmetric, reflected inertias included: kinetic energy is v^T
/// M v / 2. Units are kg, kg m or kg m^2 by pair of velocities. std::invalid_argument where `out`
/// has another size. Composite rigid bodies, docs/derivations/rigid_body.md eqs. (9)-(12).
template <typename T>
void mass_matrix(TreeStateOf<T>& state, MatrixOutOf<T> out);

/// Computes accelerations (n x 1) under these forces (n x 1, as in inverse_dynamics.hpp), by
/// Cholesky factors of M: M a = force - bias. False, and the result unchanged, where M is not
/// positive definite: a joint moves no inertia.
[[nodiscard]] bool forward_dynamics(TreeState& state, const VectorIn& force,
                                    VectorOut acceleration);

}  // namespace torquewright::dynamics
