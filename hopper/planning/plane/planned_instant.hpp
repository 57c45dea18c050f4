// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/plane/planned_motion.hpp"

namespace torquewright::hopper {

/// Interpolates within an interval of a phase: `interval` from 0, `share` of it from 0 to 1.
/// Accelerations, torques, forces and voltages are parabolas; velocities and positions their
/// integrals from the interval's beginning (docs/derivations/collocation.md eq. (3)).
PlannedInstant instant_within(const PlannedPhase& phase, std::size_t interval, double share);

/// Interpolates between the instants of a phase: positions cubic by their velocities, velocities
/// cubic by their accelerations, torques and forces linear. `share` of the phase's duration.
PlannedInstant instant_at(const PlannedPhase& phase, double share);

}  // namespace torquewright::hopper
