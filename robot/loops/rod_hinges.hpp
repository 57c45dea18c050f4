// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot/mechanisms/loop_geometry.hpp"

namespace torquewright::hopper {

/// Three hinges at one point stand for a ball at which a rod hangs. Of the bodies that they carry,
/// `balls` has the first: turns their axes so that the first is that of the loop's first own joint,
/// about which rods swing far, and the last runs along the rod, about which it spins. Hinges about
/// x, y and z lose a direction where the second stands at a right angle; these do so where the rod
/// stands along the own joint's axis.
void turn_rod_hinges(const std::vector<std::size_t>& balls, LoopGeometry& loop);

}  // namespace torquewright::hopper
