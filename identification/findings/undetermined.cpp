// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/undetermined.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {

namespace {

bool is_undetermined(const actuator::Parameter& parameter, const FoundParameters& found) {
  const FoundNumber* number = found.find(parameter.name);
  if (number == nullptr || parameter.neutral != 0.0 || number->value == 0.0) return false;
  return std::abs(number->value) <= number->standard_error;
}

}  // namespace

std::vector<std::string> undetermined_parameters(const NamedEffect& named) {
  const actuator::EffectKind* kind = actuator::find_effect(named.effect);
  std::vector<std::string> names;
  if (named.family != EffectFamily::kActuator || kind == nullptr) return names;
  for (const actuator::Parameter& parameter : kind->parameters) {
    if (is_undetermined(parameter, named.parameters)) names.emplace_back(parameter.name);
  }
  return names;
}

NamedEffect with_what_is_determined(NamedEffect named) {
  const std::vector<std::string> names = undetermined_parameters(named);
  for (FoundNumber& each : named.parameters.numbers) {
    if (std::find(names.begin(), names.end(), each.name) != names.end()) each.value = 0.0;
  }
  return named;
}

}  // namespace torquewright::identification
