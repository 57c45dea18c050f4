// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/mechanisms/four_bar.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::test {

/// Zeros, directions and branch of a four-bar linkage, drawn.
inline void mount_anyhow(oracles::Dice& dice, hopper::FourBarGeometry& links) {
  links.crank_zero_rad = uniform(dice, -3, 3);
  links.rocker_zero_rad = uniform(dice, -3, 3);
  links.crank_direction = dice.chance(50) ? 1 : -1;
  links.rocker_direction = dice.chance(50) ? 1 : -1;
  links.branch = dice.chance(50) ? 1 : -1;
}

}  // namespace torquewright::test
