// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// Symmetric, reflected inertias included: kinetic energy is v^T M v / 2.
/// Composite rigid bodies, docs/derivations/rigid_body.md eqs. (9)-(12).
void mass_matrix(TreeState& state, MatrixOut out);

/// Accelerations under these forces (as in inverse_dynamics.hpp). False, and the result untouched,
/// where M is not positive definite: a joint that moves no inertia.
[[nodiscard]] bool forward_dynamics(TreeState& state, const VectorIn& force,
                                    VectorOut acceleration);

}  // namespace torquewright::dynamics
