// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::test {

Eigen::Vector3d random_direction(oracles::Dice& dice);
Eigen::Matrix3d random_rotation(oracles::Dice& dice);
/// Positive definite, the triangle inequality kept.
dynamics::RigidInertia random_inertia(oracles::Dice& dice);

/// Branching anywhere, revolute and prismatic joints along any axis, reflected inertia on half of
/// them; no rotor spin.
dynamics::Tree random_tree(oracles::Dice& dice, dynamics::BaseKind base, std::size_t joints);
/// Angles beyond a turn, a quaternion that is not a unit one.
Eigen::VectorXd random_position(oracles::Dice& dice, const dynamics::Tree& tree);

}  // namespace torquewright::test
