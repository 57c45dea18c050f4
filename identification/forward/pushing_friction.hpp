// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"

namespace torquewright::identification {

/// Whether friction that varies with the angle would push: at `speed_rad_s` all drag together is
/// negative at some angle of the output, by more than the fit's own error. Friction must take
/// power, whatever its waves.
bool friction_pushes(const actuator::Actuator& actuator, double speed_rad_s);

}  // namespace torquewright::identification
