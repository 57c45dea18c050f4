// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"

namespace torquewright::identification {

/// Returns how far the motor leads the output, in rad at the output, at each sample of a stretch,
/// under the load's torque (Instant::load_torque_Nm). Springs and gaps of the actuator follow it at
/// once; hysteresis beside a spring follows the twist's own history, and begins at zero.
std::vector<double> twist_under_load_rad(const actuator::Actuator& actuator,
                                         const std::vector<actuator::Instant>& at);

}  // namespace torquewright::identification
