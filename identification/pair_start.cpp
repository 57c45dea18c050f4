// SPDX-License-Identifier: Apache-2.0
#include "identification/pair_start.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace torquewright::identification {
namespace {

constexpr std::size_t kPairVariants = 3;  ///< Of each effect.

/// The variants of each effect (waves: of each order) that leave least when they stand alone.
std::vector<std::size_t> best_alone(const Trials& trials) {
  std::map<std::string, std::vector<std::pair<double, std::size_t>>> by_effect;
  for (const std::size_t v : trials.options().variants) {
    const Fit alone = trials.fitter().fit({v});
    if (!alone.is_valid) continue;
    const Variant& variant = trials.variant(v);
    by_effect[variant.effect + (variant.order > 0.0 ? std::to_string(variant.order) : "")]
        .emplace_back(alone.loss, v);
  }
  std::vector<std::size_t> few;
  for (auto& [effect, list] : by_effect) {
    std::sort(list.begin(), list.end());
    for (std::size_t k = 0; k < std::min(kPairVariants, list.size()); ++k) {
      few.push_back(list[k].second);
    }
  }
  return few;
}

}  // namespace

Fit best_pair(const Trials& trials) {
  const std::vector<std::size_t> few = best_alone(trials);
  Fit best;
  for (std::size_t a = 0; a < few.size(); ++a) {
    for (std::size_t b = a + 1; b < few.size(); ++b) {
      if (!trials.may_join({few[a]}, few[b])) continue;
      const Fit pair = trials.fitter().fit({few[a], few[b]});
      if (!beats(pair, best)) continue;
      if (trials.accepts(trials.empty(), pair) && trials.is_sound(pair)) best = pair;
    }
  }
  return best;
}

}  // namespace torquewright::identification
