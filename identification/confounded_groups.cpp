// SPDX-License-Identifier: Apache-2.0
#include "identification/confounded_groups.hpp"

#include <algorithm>

#include "identification/confusions.hpp"
#include "identification/dictionary.hpp"

namespace torquewright::identification {
namespace {

constexpr double kLeastSlowShare = 0.02;  ///< Of samples, for friction at rest to be told.

}  // namespace

std::optional<Confounded> alike_in_log(const Bench& bench, const Group& group) {
  const std::string& own = group.effects.front();
  const std::vector<std::string> exact = exact_identities(bench, own);
  Confounded confounded;
  confounded.effects = {own};
  for (std::size_t k = 1; k < group.effects.size(); ++k) {
    if (std::find(exact.begin(), exact.end(), group.effects[k]) == exact.end()) {
      confounded.effects.push_back(group.effects[k]);
    }
  }
  if (confounded.effects.size() < 2) return std::nullopt;
  confounded.separated_by = separated_by(bench, confounded.effects);
  return confounded;
}

std::optional<Confounded> alike_on_rig(const Bench& bench, const std::string& effect) {
  Confounded confounded;
  confounded.effects = exact_identities(bench, effect);
  if (confounded.effects.size() < 2) return std::nullopt;
  confounded.exact = true;
  confounded.separated_by = separated_by(bench, confounded.effects);
  confounded.consequence = consequence(confounded.effects);
  return confounded;
}

std::optional<Confounded> alike_when_fast(const Bench& bench, const std::vector<Signals>& signals,
                                          const std::string& effect) {
  if (effect != "coulomb_friction") return std::nullopt;
  if (extent_of(signals).slow_share >= kLeastSlowShare) return std::nullopt;
  Confounded confounded;
  confounded.effects = {"coulomb_friction", "stribeck_friction", "presliding_friction"};
  confounded.separated_by = separated_by(bench, confounded.effects);
  return confounded;
}

}  // namespace torquewright::identification
