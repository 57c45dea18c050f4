// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/with_effects.hpp"

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

actuator::Effect effect_of(const NamedEffect& named) {
  actuator::Effect effect = actuator::neutral(*actuator::find_effect(named.effect));
  effect.provenance = "identified";
  for (std::size_t p = 0; p < effect.values.size(); ++p) {
    const std::string name(effect.kind->parameters[p].name);
    if (named.parameters.contains(name)) effect.values[p] = named.parameters[name];
  }
  if (!effect.kind->has_harmonics) return effect;
  effect.harmonics.clear();
  effect.proportional = named.parameters.value("proportional", false);
  const char* amplitude = effect.proportional ? "amplitude_ratio" : "amplitude_Nm";
  for (const auto& each : named.parameters["harmonics"]) {
    effect.harmonics.push_back(
        {each.value("order", 1.0), each.value(amplitude, 0.0), each.value("phase_rad", 0.0)});
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
