// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/stepper/equations_of_motion.hpp"

namespace torquewright::simulation {

/// Returns the direction of motion of each joint; at rest it is the direction in which the joint
/// starts, 0 if friction holds it (docs/derivations/simulation.md section 2).
std::vector<double> directions_of(EquationsOfMotion& equations, const PlantState& state,
                                  const std::vector<DriveNow>& drive);

}  // namespace torquewright::simulation
