// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"

namespace torquewright::identification {

/// How far the motor leads the output, in rad at the output, at each sample of a stretch, under the
/// torque on the load (Instant::load_torque_Nm). Springs and gaps of the actuator's train follow it
/// at once; hysteresis beside a spring takes its part by the twist's own history, and has taken
/// none before the first sample.
std::vector<double> twist_under_load_rad(const actuator::Actuator& actuator,
                                         const std::vector<actuator::Instant>& at);

}  // namespace torquewright::identification
