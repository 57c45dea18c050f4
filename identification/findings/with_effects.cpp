// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/with_effects.hpp"

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

actuator::Effect effect_of(const NamedEffect& named) {
  actuator::Effect effect = actuator::neutral(*actuator::find_effect(named.effect));
  effect.provenance = "identified";
  for (std::size_t p = 0; p < effect.values.size(); ++p) {
    effect.values[p] = named.parameters.value(effect.kind->parameters[p].name, effect.values[p]);
  }
  if (!effect.kind->has_harmonics) return effect;
  effect.harmonics.clear();
  effect.proportional = named.parameters.proportional.value_or(false);
  for (const FoundWave& wave : named.parameters.waves) {
    effect.harmonics.push_back({wave.order, wave.amplitude.value, wave.phase_rad.value});
  }
  return effect;
}

}  // namespace

bool is_listed(const std::string& names, std::string_view name) {
  return (", " + names + ",").find(", " + std::string(name) + ",") != std::string::npos;
}

actuator::Actuator with_effects(actuator::Actuator actuator,
                                const std::vector<NamedEffect>& found) {
  for (const NamedEffect& named : found) {
    if (named.family != EffectFamily::kActuator) continue;
    std::erase_if(actuator.effects, [&](const actuator::Effect& stated) {
      return is_listed(named.replaces, stated.kind->name);
    });
    actuator.effects.push_back(effect_of(named));
  }
  return actuator;
}

}  // namespace torquewright::identification
