// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// Computes the position after duration_s at constant velocity (that of a spatial base's rotation
/// is constant in the base's axes): exact, not a step of an integrator. The result's quaternion is
/// a unit one. std::invalid_argument on wrong sizes. `out` may be the position itself.
void step_position(const Tree& tree, const VectorIn& position, const VectorIn& velocity,
                   double duration_s, VectorOut out);

/// Computes the velocity (n x 1) that leads from one position to another within one second: the
/// inverse of step_position(), a spatial base turning the shorter way. std::invalid_argument on
/// wrong sizes.
void position_difference(const Tree& tree, const VectorIn& from, const VectorIn& to, VectorOut out);

/// Computes how fast the step (n x 1, of one second) that leads to the present position grows while
/// the tree moves at `velocity` (n x 1): the velocity, but for a rotation whose axis turns. To the
/// second order of the rotation, which an integrator of fourth order needs. std::invalid_argument
/// on wrong sizes. `out` may be the velocity itself.
void step_rate(const Tree& tree, const VectorIn& step, const VectorIn& velocity, VectorOut out);

}  // namespace torquewright::dynamics
