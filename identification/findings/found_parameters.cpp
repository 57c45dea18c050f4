// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/found_parameters.hpp"

#include <algorithm>

namespace torquewright::identification {

const FoundNumber* FoundParameters::find(std::string_view name) const {
  const auto found = std::find_if(numbers.begin(), numbers.end(),
                                  [&](const FoundNumber& each) { return each.name == name; });
  return found == numbers.end() ? nullptr : &*found;
}

double FoundParameters::value(std::string_view name, double otherwise) const {
  const FoundNumber* number = find(name);
  return number == nullptr ? otherwise : number->value;
}

double FoundParameters::standard_error(std::string_view name) const {
  const FoundNumber* number = find(name);
  return number == nullptr ? FoundNumber().standard_error : number->standard_error;
}

std::vector<const FoundNumber*> FoundParameters::every_number() const {
  std::vector<const FoundNumber*> all;
  for (const FoundNumber& each : numbers) all.push_back(&each);
  for (const FoundWave& wave : waves) {
    all.push_back(&wave.amplitude);
    all.push_back(&wave.phase_rad);
  }
  return all;
}

std::vector<FoundNumber*> FoundParameters::every_number() {
  std::vector<FoundNumber*> all;
  for (FoundNumber& each : numbers) all.push_back(&each);
  for (FoundWave& wave : waves) {
    all.push_back(&wave.amplitude);
    all.push_back(&wave.phase_rad);
  }
  return all;
}

}  // namespace torquewright::identification
