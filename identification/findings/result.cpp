// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/result.hpp"

#include <algorithm>

namespace torquewright::identification {

std::string_view name_of(EffectFamily family) {
  switch (family) {
    case EffectFamily::kActuator:
      return "actuator";
    case EffectFamily::kRig:
      return "rig";
    case EffectFamily::kLog:
      return "log";
  }
  return "";
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kExplained:
      return "explained";
    case Verdict::kPartlyExplained:
      return "partly_explained";
    case Verdict::kUnexplained:
      return "unexplained";
    case Verdict::kNothingMissing:
      return "nothing_missing";
    case Verdict::kCannotTell:
      return "cannot_tell";
  }
  return "";
}

std::vector<const NamedEffect*> certain_of(const EquationResult& result) {
  std::vector<const NamedEffect*> certain;
  for (const NamedEffect& effect : result.added) {
    if (is_certain(result, effect.effect)) certain.push_back(&effect);
  }
  return certain;
}

bool is_certain(const EquationResult& result, const std::string& effect) {
  const bool is_in_doubt = std::any_of(
      result.added.begin(), result.added.end(),
      [&](const NamedEffect& each) { return each.effect == effect && !each.doubt.empty(); });
  if (is_in_doubt) return false;
  return std::none_of(result.confounded.begin(), result.confounded.end(), [&](const auto& group) {
    const bool is_only_a_name = group.exact && group.consequence.empty();
    return !is_only_a_name &&
           std::find(group.effects.begin(), group.effects.end(), effect) != group.effects.end();
  });
}

}  // namespace torquewright::identification
