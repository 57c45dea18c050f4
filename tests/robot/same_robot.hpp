// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/model/robot.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright::test {

/// A random tree with named joints, half of them limited.
hopper::Robot random_robot(oracles::Dice& dice, dynamics::BaseKind base);

/// Largest relative difference of mass matrices and biases at random states, joints matched by
/// their names; infinite if the robots do not have the same joints or base.
double dynamic_difference(const hopper::Robot& one, const hopper::Robot& other);

}  // namespace torquewright::test
