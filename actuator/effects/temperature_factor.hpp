// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "actuator/effects/effect.hpp"

namespace torquewright::actuator::effects {

/// 1 + a (T - T_ref): the law of a factor whose one parameter a is a relative change per kelvin.
inline double temperature_factor(const Effect& effect, const Instant& at) {
  return 1.0 + effect.values[0] * (at.winding_temperature_K - at.reference_temperature_K);
}

/// Its derivative by a.
inline void temperature_factor_gradient(const Effect& /*effect*/, const Instant& at,
                                        std::span<double> derivative) {
  derivative[0] = at.winding_temperature_K - at.reference_temperature_K;
}

}  // namespace torquewright::actuator::effects
