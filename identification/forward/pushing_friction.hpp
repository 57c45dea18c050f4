// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"

namespace torquewright::identification {

/// Whether friction that varies with the angle would push somewhere: at `speed_rad_s` all drag
/// together is less than nothing at some angle of the output, by more than the fit's own error.
/// Friction takes power, whatever its waves.
bool friction_pushes(const actuator::Actuator& actuator, double speed_rad_s);

}  // namespace torquewright::identification
