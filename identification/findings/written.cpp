// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/written.hpp"

#include <algorithm>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

bool holds(const Confounded& group, const std::string& effect) {
  return std::find(group.effects.begin(), group.effects.end(), effect) != group.effects.end();
}

bool is_all_of_actuator(const Confounded& group) {
  return std::all_of(group.effects.begin(), group.effects.end(), [](const std::string& effect) {
    return actuator::find_effect(effect) != nullptr;
  });
}

/// Whether it stands for a group of this log alone, one of which acts.
bool is_best_of_group(const EquationResult& result, const NamedEffect& named) {
  return named.doubt.empty() &&
         std::all_of(result.confounded.begin(), result.confounded.end(), [&](const auto& group) {
           const bool is_only_a_name = group.exact && group.consequence.empty();
           return !holds(group, named.effect) || is_only_a_name ||
                  (!group.exact && is_all_of_actuator(group));
         });
}

}  // namespace

bool is_trusted(const EquationResult& equation) {
  return equation.verdict != Verdict::kUnexplained && equation.not_one_rig.empty();
}

std::vector<std::string> undecided_with(const EquationResult& result, const std::string& effect) {
  std::vector<std::string> others;
  for (const Confounded& group : result.confounded) {
    if (group.exact || !holds(group, effect)) continue;
    for (const std::string& each : group.effects) {
      const bool is_known = std::find(others.begin(), others.end(), each) != others.end();
      if (each != effect && !is_known) others.push_back(each);
    }
  }
  return others;
}

std::vector<const NamedEffect*> written_of(const EquationResult& result) {
  std::vector<const NamedEffect*> written;
  for (const NamedEffect& each : result.added) {
    if (!is_trusted(result) || each.family != EffectFamily::kActuator) continue;
    if (is_certain(result, each.effect) || is_best_of_group(result, each)) written.push_back(&each);
  }
  return written;
}

}  // namespace torquewright::identification
