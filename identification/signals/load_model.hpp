// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/effects/effect.hpp"
#include "identification/rig/rig.hpp"
#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// Returns the torque that the load of the signals' run takes by its stated values: inertia and
/// gravity. Not for a dynamometer, whose load is unknown.
std::vector<double> model_load_Nm(const Rig& rig, std::size_t joint, const Signals& signals);

/// Derivative of that torque by the load's own mass, at one sample (not for arms).
double load_mass_column(const Load& load, const actuator::Instant& at);

}  // namespace torquewright::identification
