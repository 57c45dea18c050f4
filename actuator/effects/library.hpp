// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "actuator/effects/effect.hpp"

namespace torquewright::actuator {

/// Every effect of an actuator, in the order of docs/effects.md.
std::span<const EffectKind* const> effect_library();

/// The effect of that name; nullptr if there is none.
const EffectKind* find_effect(std::string_view name);

/// The effect at the parameters at which it changes nothing; no harmonics.
Effect neutral(const EffectKind& kind);

/// The effects that look so in a balance of torques, in the library's order.
std::vector<const EffectKind*> effects_standing_for(StandsFor what);

/// Whether an effect of that name is in the library and looks so in a balance of torques.
bool stands_for(std::string_view name, StandsFor what);

/// Whether an effect of that name is in the library and is dry friction that varies by the angle.
bool is_wave_of_friction(std::string_view name);

/// What an effect of that name holds at rest; nothing where the library has none.
AtRest at_rest_of(std::string_view name);

/// The library's first friction that holds so at rest. Throws where there is none.
const EffectKind& first_friction(AtRest at_rest);

/// The library's first effect with harmonics that acts there. Throws where there is none.
const EffectKind& first_wave(Acts acts);

}  // namespace torquewright::actuator
