// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/stepper/plant_motion.hpp"

namespace torquewright::simulation {

/// Motors that come to rest within a step: friction reverses there, so a step ends there.

/// Share of the part from `from` to `to` after which the first motor stops, if it slows down
/// evenly; 1 or more: none stops within it.
double share_to_stop(const PlantState& from, const PlantState& to,
                     const std::vector<double>& directions);

/// Sets to zero the speeds of motors that reversed within a step or that friction holds.
void stop_reversed(PlantState& state, const std::vector<double>& directions,
                   const std::vector<JointModel>& models);

/// Sets to zero the speeds of motors that lost nearly all of their speed between two instants.
void stop_slowed(const PlantState& from, PlantState& to, const std::vector<JointModel>& models);

}  // namespace torquewright::simulation
