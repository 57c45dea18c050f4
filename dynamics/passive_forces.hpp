// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// Below this speed (rad/s or m/s) a joint rests: it is what rounding leaves of none.
inline constexpr double kRest = 1e-9;

/// Adds to forces that a motion needs (n x 1, as inverse_dynamics() writes them) what the dampers
/// and springs of joints take beside: d q' + k (q - q_0); docs/derivations/passive_forces.md eq.
/// (1).
template <typename T>
void add_dampers_and_springs(const TreeStateOf<T>& state, VectorOutOf<T> force);

/// Adds what dry friction takes, smoothed about rest: f q' / sqrt(q'^2 + w^2), which is within 0.5
/// % of f above ten times the width w (rad/s or m/s); eq. (4). For what must be differentiated: at
/// rest it holds nothing.
template <typename T>
void add_smooth_friction(const TreeStateOf<T>& state, double width, VectorOutOf<T> force);

/// Adds what dry friction takes of joints that move, or that rest and are about to move as the
/// acceleration (n x 1) says: f against it; eq. (2).
void add_dry_friction(const TreeState& state, const VectorIn& acceleration, VectorOut force);

/// Writes what dry friction holds (n x 1) of joints that rest and stay so: of a needed force (n x
/// 1) up to the static friction, of other rows nothing; eq. (3).
void held_by_friction(const TreeState& state, const VectorIn& acceleration, const VectorIn& needed,
                      VectorOut held);

/// What friction of that joint holds or takes at most at this speed: static friction at rest.
double friction_limit(const PassiveForces& passive, double speed);

}  // namespace torquewright::dynamics
