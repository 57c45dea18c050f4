// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/stepper/plant_motion.hpp"

namespace torquewright::simulation {

/// Motors that come to rest within a step: friction reverses there, so a step ends there.

/// How much of the part that led from `from` to `to` it takes until the first motor stops, if it
/// slows down evenly; 1 or more: none stops within it.
double share_to_stop(const PlantState& from, const PlantState& to,
                     const std::vector<double>& directions);

/// Sets the speeds of motors to zero that reversed within a step, or that friction holds.
void stop_reversed(PlantState& state, const std::vector<double>& directions,
                   const std::vector<JointModel>& models);

/// Sets the speeds of motors to zero that lost nearly all of it between two instants.
void stop_slowed(const PlantState& from, PlantState& to, const std::vector<JointModel>& models);

}  // namespace torquewright::simulation
