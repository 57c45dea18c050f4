// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/effects/effect.hpp"

namespace torquewright::actuator::effects {

/// Linear factor of temperature: 1 + a (T - T_ref).
inline double temperature_factor(double coefficient_1_K, const Instant& at) {
  return 1.0 + coefficient_1_K * (at.winding_temperature_K - at.reference_temperature_K);
}

/// The law of an effect whose one parameter is that coefficient.
inline double temperature_factor(const Effect& effect, const Instant& at) {
  return temperature_factor(effect.values[0], at);
}

}  // namespace torquewright::actuator::effects
