// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "actuator/effects/effect.hpp"

namespace torquewright::actuator {

/// Every effect of an actuator, in the order of docs/effects.md.
std::span<const EffectKind* const> effect_library();

/// The effect of that name; nullptr if there is none.
const EffectKind* find_effect(std::string_view name);

/// The effect at the parameters at which it changes nothing; no harmonics.
Effect neutral(const EffectKind& kind);

}  // namespace torquewright::actuator
