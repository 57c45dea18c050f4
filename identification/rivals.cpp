// SPDX-License-Identifier: Apache-2.0
#include "identification/rivals.hpp"

#include <cmath>
#include <set>

#include "identification/compatibility.hpp"

namespace torquewright::identification {
namespace {

constexpr double kKeepsGain = 0.5;   ///< A rival that keeps less of the gain is refuted.
constexpr double kSameGain = 0.985;  ///< A rival that keeps more is never refuted.
constexpr double kRivalLoss = 0.10;  ///< A rival that loses more of the rest, and
constexpr double kRivalT = 2.5;      ///< by so many errors in two runs, is refuted.

/// Gain in one fold over its own standard error.
double fold_t(const Fitter& fitter, const Fit& worse, const Fit& better, std::size_t fold) {
  double gain = 0.0, square = 0.0;
  for (std::size_t b = 0; b < fitter.folds().size(); ++b) {
    if (fitter.folds()[b] != fold) continue;
    const double less = worse.block_loss[b] - better.block_loss[b];
    const double rest = less - fitter.difference(better, worse, b);
    gain += less;
    square += rest * rest;
  }
  return square > 0.0 ? gain / std::sqrt(square) : 0.0;
}

/// `less`: the model without the member, whose place the rival's variant takes.
bool is_refuted(const Trials& trials, const Fit& model, const Fit& less, const Fit& rival) {
  const double kept = (less.loss - rival.loss) / (less.loss - model.loss);
  if (kept < kKeepsGain) return true;
  if (kept > kSameGain) return false;  // What tells them apart is less than laws are known to.
  const Gain back = gain_of(trials.fitter(), rival, model, trials.options().rules);
  if (back.loss <= kRivalLoss * std::abs(model.loss)) return false;
  std::size_t runs = 0;
  for (std::size_t f = 0; f < trials.fitter().fold_count(); ++f) {
    if (fold_t(trials.fitter(), rival, model, f) > kRivalT) ++runs;
  }
  return runs >= 2 || back.t > 2.0 * kRivalT;
}

}  // namespace

Group group_of(const Trials& trials, const Fit& model, std::size_t place) {
  const Variant& own = trials.variant(model.members[place]);
  const Fit less = trials.without(model, place);
  const Members rest = less_one(model.members, place);
  std::set<std::string> others;
  for (const std::size_t v : trials.options().variants) {
    const Variant& other = trials.variant(v);
    if (other.effect == own.effect || contains(other, own.effect)) continue;
    if (others.count(other.effect) != 0 || !trials.may_join(rest, v)) continue;
    const Fit rival = trials.fitter().fit(plus_one(rest, v));
    if (rival.is_valid && !is_refuted(trials, model, less, rival)) others.insert(other.effect);
  }
  Group group{place, {own.effect}};
  group.effects.insert(group.effects.end(), others.begin(), others.end());
  return group;
}

}  // namespace torquewright::identification
