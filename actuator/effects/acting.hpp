// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/effects/effect.hpp"

namespace torquewright::actuator {

/// Returns the sum of the laws of the effects that act there; 0 without any.
inline double sum_of_laws(const std::vector<Effect>& effects, Acts acts, const Instant& at) {
  double sum = 0.0;
  for (const Effect& effect : effects) {
    if (effect.kind->acts == acts) sum += effect.kind->law(effect, at);
  }
  return sum;
}

/// Returns the product of the laws of the effects that act there; 1 without any.
inline double product_of_laws(const std::vector<Effect>& effects, Acts acts, const Instant& at) {
  double product = 1.0;
  for (const Effect& effect : effects) {
    if (effect.kind->acts == acts) product *= effect.kind->law(effect, at);
  }
  return product;
}

}  // namespace torquewright::actuator
