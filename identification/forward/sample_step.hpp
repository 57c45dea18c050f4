// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/forward/equation.hpp"

namespace torquewright::identification {

/// Half of the shortest time between samples; 0 for a log without times. A delay below it cannot be
/// told from the unknown instant of its step at which a sample was taken.
double half_a_step_s(const std::vector<Signals>& signals);

/// Name of that instant among the values that every model fits.
inline constexpr const char* kInstant = "instant";

/// Adds that instant to the values that every model of the equation fits, within half a step to
/// either side.
void add_instant(double half_a_step_s, double LogErrors::*instant, ForwardEquation& equation);

}  // namespace torquewright::identification
