// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/stepper/equations_of_motion.hpp"

namespace torquewright::simulation {

/// Directions of motion: of a joint at rest that in which it starts; 0: friction holds it.
/// docs/derivations/simulation.md section 2.
std::vector<double> directions_of(EquationsOfMotion& equations, const PlantState& state,
                                  const std::vector<DriveNow>& drive);

}  // namespace torquewright::simulation
