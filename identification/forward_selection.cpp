// SPDX-License-Identifier: Apache-2.0
#include "identification/forward_selection.hpp"

#include <algorithm>

#include "identification/compatibility.hpp"
#include "identification/pair_start.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kMostMembers = 7;  ///< Waves of one effect count as one.
constexpr int kMostRounds = 6;           ///< Of swapping.
constexpr double kFalls = 1.0 - 1e-9;    ///< Times the loss: lower beyond round-off.

/// Drops members that no longer earn their place, the weakest first.
Fit pruned(const Trials& trials, Fit fit) {
  while (!fit.members.empty()) {
    Fit best;
    for (std::size_t place = 0; place < fit.members.size(); ++place) {
      if (trials.accepts(trials.without(fit, place), fit)) continue;
      const Fit less = trials.fitter().fit(less_one(fit.members, place));
      if (beats(less, best)) best = less;
    }
    if (!best.is_valid) return fit;
    fit = best;
  }
  return fit;
}

bool are_waves_of_one(const Variant& a, const Variant& b) {
  return a.order > 0.0 && b.order > 0.0 && a.effect == b.effect && a.proportional == b.proportional;
}

std::size_t count_effects(const Trials& trials, const Members& members) {
  std::size_t effects = 0;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const auto before = members.begin() + static_cast<std::ptrdiff_t>(m);
    effects += std::none_of(members.begin(), before, [&](std::size_t each) {
      return are_waves_of_one(trials.variant(each), trials.variant(members[m]));
    });
  }
  return effects;
}

/// The acceptable variant with the least loss, added; not valid if there is none.
Fit with_one_more(const Trials& trials, const Fit& fit) {
  Fit best;
  for (const std::size_t added : trials.options().variants) {
    if (!trials.may_join(fit.members, added)) continue;
    const Fit with = trials.fitter().fit(plus_one(fit.members, added));
    if (beats(with, best) && trials.accepts(fit, with)) best = with;
  }
  return best;
}

/// Two waves of one effect at once. Neighbouring orders beat: over the part of a turn that was left
/// out one of them alone is off by as much as the other is strong, and neither earns its place
/// before the other is there.
Fit with_two_waves_more(const Trials& trials, const Fit& fit) {
  Fit best;
  const std::vector<std::size_t>& variants = trials.options().variants;
  for (std::size_t a = 0; a < variants.size(); ++a) {
    if (!trials.may_join(fit.members, variants[a])) continue;
    const Members one = plus_one(fit.members, variants[a]);
    for (std::size_t b = a + 1; b < variants.size(); ++b) {
      if (!are_waves_of_one(trials.variant(variants[a]), trials.variant(variants[b]))) continue;
      if (!trials.may_join(one, variants[b])) continue;
      const Fit with = trials.fitter().fit(plus_one(one, variants[b]));
      if (!beats(with, best) || !trials.accepts(fit, with)) continue;
      const std::size_t last = with.members.size() - 1;
      const bool both_earn = trials.accepts(trials.without(with, last), with) &&
                             trials.accepts(trials.without(with, last - 1), with);
      if (both_earn) best = with;
    }
  }
  return best;
}

/// Adds the acceptable variant with the least loss, or two waves, until there is none.
Fit grown(const Trials& trials, Fit fit) {
  while (fit.is_valid && count_effects(trials, fit.members) < kMostMembers) {
    Fit best = with_one_more(trials, fit);
    if (!best.is_valid) best = with_two_waves_more(trials, fit);
    if (!best.is_valid) return fit;
    Fit next = pruned(trials, best);
    if (next.loss >= fit.loss) return fit;  // So that no set comes round again.
    fit = std::move(next);
  }
  return fit;
}

/// The best model with one member swapped for another variant; the same if none is better.
Fit swapped(const Trials& trials, const Fit& fit) {
  Fit best = fit;
  for (std::size_t place = 0; place < fit.members.size(); ++place) {
    const Members rest = less_one(fit.members, place);
    for (const std::size_t other : trials.options().variants) {
      if (!trials.may_join(rest, other)) continue;
      Members members = rest;
      members.insert(members.begin() + static_cast<std::ptrdiff_t>(place), other);
      const Fit with = trials.fitter().fit(members);
      if (with.is_valid && with.loss < best.loss * kFalls) best = with;
    }
  }
  return best;
}

/// Swaps members for others while the loss falls, and grows again.
Fit settled(const Trials& trials, Fit fit) {
  for (int round = 0; round < kMostRounds; ++round) {
    Fit best = swapped(trials, fit);
    if (best.loss >= fit.loss) return fit;
    best = grown(trials, pruned(trials, best));
    if (best.loss >= fit.loss && best.members.size() >= fit.members.size()) return fit;
    fit = best;
  }
  return fit;
}

/// The effects that one holds: each alone, and all together.
std::vector<Members> parts_of(const Trials& trials, const Variant& whole) {
  std::vector<Members> parts;
  Members all;
  for (const std::size_t v : trials.options().variants) {
    if (!contains(whole, trials.variant(v).effect)) continue;
    parts.push_back({v});
    all.push_back(v);
  }
  if (all.size() > 1) parts.push_back(all);
  return parts;
}

/// The best model with what the member at a place holds instead of it, where the member is not
/// better beyond chance; not valid if there is none.
Fit with_parts(const Trials& trials, const Fit& fit, std::size_t place) {
  Fit best;
  for (const Members& parts : parts_of(trials, trials.variant(fit.members[place]))) {
    Members members = less_one(fit.members, place);
    members.insert(members.end(), parts.begin(), parts.end());
    const Fit simple = trials.fitter().fit(members);
    if (simple.is_valid && !trials.accepts(simple, fit) && beats(simple, best)) best = simple;
  }
  return best;
}

/// An effect that holds others gives way to them unless it is better beyond chance.
Fit simplified(const Trials& trials, Fit fit) {
  for (std::size_t place = 0; place < fit.members.size(); ++place) {
    const Fit simple = with_parts(trials, fit, place);
    if (simple.is_valid) return simplified(trials, pruned(trials, simple));
  }
  return fit;
}

/// A rival start replaces a model if it is better beyond its own error or has no more members.
bool is_better(const Trials& trials, const Fit& old, const Fit& rival) {
  const AcceptanceRules& rules = trials.options().rules;
  const Gain gain = gain_of(trials.fitter(), old, rival, rules);
  return rival.members.size() > old.members.size() ? gain.t > rules.least_t : gain.loss > 0.0;
}

}  // namespace

Fit best_model(const Trials& trials) {
  Fit best = settled(trials, grown(trials, trials.empty()));
  const Fit start = best_pair(trials);
  if (start.is_valid) {
    const Fit other = settled(trials, grown(trials, start));
    if (other.is_valid && trials.is_sound(other) && other.loss < best.loss &&
        is_better(trials, best, other)) {
      best = other;
    }
  }
  return simplified(trials, best);
}

}  // namespace torquewright::identification
