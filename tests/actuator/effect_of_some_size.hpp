// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "actuator/effects/effect.hpp"

namespace torquewright::actuator {

/// An effect of that kind that changes something: each parameter away from its neutral value by
/// about a fifth of a unit, stiffnesses at 300, one wave. For tests that walk the whole library.
inline Effect effect_of_some_size(const EffectKind& kind) {
  Effect effect;
  effect.kind = &kind;
  effect.provenance = "test";
  double value = 0.2;
  for (const Parameter& parameter : kind.parameters) {
    const bool is_free = std::isfinite(parameter.neutral);
    // Each a little larger, so that what is not to be below another is not.
    effect.values.push_back(
        is_free ? std::min(parameter.neutral + (value += 0.05), parameter.highest) : 300.0);
  }
  if (kind.has_harmonics) effect.harmonics = {{3.0, 0.2, 0.4}};
  return effect;
}

}  // namespace torquewright::actuator
