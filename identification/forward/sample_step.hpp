// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/forward/equation.hpp"

namespace torquewright::identification {

/// Half of the shortest time between samples; 0 for a log without times. At which instant of its
/// step a sample was taken no log says, so that less than this is no delay.
double half_a_step_s(const std::vector<Signals>& signals);

/// Its name among the values that every model fits.
inline constexpr const char* kInstant = "instant";

/// Frees that instant in every model of the equation, within half a step to either side.
void add_instant(double half_a_step_s, double LogErrors::*instant, ForwardEquation& equation);

}  // namespace torquewright::identification
