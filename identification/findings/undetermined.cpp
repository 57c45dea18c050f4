// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/undetermined.hpp"

#include <cmath>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {

std::vector<std::string> undetermined_parameters(const NamedEffect& named) {
  const actuator::EffectKind* kind = actuator::find_effect(named.effect);
  std::vector<std::string> names;
  if (named.family != EffectFamily::kActuator || kind == nullptr) return names;
  for (const actuator::Parameter& parameter : kind->parameters) {
    const std::string name(parameter.name);
    const bool has_error = named.parameters.contains(name) && named.parameters[name].is_number() &&
                           named.standard_error.contains(name) &&
                           named.standard_error[name].is_number();
    if (!has_error || parameter.neutral != 0.0) continue;
    const double value = named.parameters[name].get<double>();
    const bool is_larger = std::abs(value) > named.standard_error[name].get<double>();
    if (value != 0.0 && !is_larger) names.push_back(name);
  }
  return names;
}

NamedEffect with_what_is_determined(NamedEffect named) {
  for (const std::string& name : undetermined_parameters(named)) named.parameters[name] = 0.0;
  return named;
}

}  // namespace torquewright::identification
