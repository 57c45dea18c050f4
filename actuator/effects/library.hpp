// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "actuator/effects/effect.hpp"

namespace torquewright::actuator {

/// Returns all effects of an actuator, in the order of docs/effects.md.
std::span<const EffectKind* const> effect_library();

/// Finds the effect of that name; nullptr if there is none.
const EffectKind* find_effect(std::string_view name);

/// Returns the effect with the parameters at which it changes nothing; no harmonics.
Effect neutral(const EffectKind& kind);

/// Returns the effects that look so in a balance of torques, in the library's order.
std::vector<const EffectKind*> effects_standing_for(StandsFor what);

/// Whether an effect of that name is in the library and looks so in a balance of torques.
bool stands_for(std::string_view name, StandsFor what);

/// Whether an effect of that name is in the library and is dry friction that varies by the angle.
bool is_wave_of_friction(std::string_view name);

/// Returns what an effect of that name holds at rest; kNothing where the library has none.
AtRest at_rest_of(std::string_view name);

/// Returns the library's first friction that holds so at rest. Throws where there is none.
const EffectKind& first_friction(AtRest at_rest);

/// Returns the library's first effect with harmonics that acts there. Throws where there is none.
const EffectKind& first_wave(Acts acts);

}  // namespace torquewright::actuator
