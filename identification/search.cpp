// SPDX-License-Identifier: Apache-2.0
#include "identification/search.hpp"

#include <limits>
#include <map>
#include <set>

#include "identification/forward_selection.hpp"
#include "identification/rivals.hpp"
#include "identification/trials.hpp"

namespace torquewright::identification {
namespace {

/// The place in `left` whose member lowers the loss most on top of `order`, and that model.
std::pair<std::size_t, Fit> next_of(const Trials& trials, const Members& left,
                                    const Members& order) {
  Fit best;
  std::size_t at = 0;
  for (std::size_t k = 0; k < left.size(); ++k) {
    const Fit with = trials.fitter().fit(plus_one(order, left[k]));
    if (!beats(with, best)) continue;
    best = with;
    at = k;
  }
  return {at, best};
}

/// Members in the order in which they gain most, each on top of those before it.
void put_in_order(const Trials& trials, const Fit& fit, Selection& selection) {
  Members left = fit.members, order;
  selection.model = trials.empty();
  while (!left.empty()) {
    const auto [at, best] = next_of(trials, left, order);
    order.push_back(left[at]);
    left = less_one(left, at);
    selection.model = best.is_valid ? best : trials.fitter().fit(order);
    selection.path.push_back(selection.model);
  }
}

/// Gains and rivals of each member.
void add_gains(const Trials& trials, Selection& selection) {
  const Fit& model = selection.model;
  for (std::size_t place = 0; place < model.members.size(); ++place) {
    selection.gains.push_back(
        gain_of(trials.fitter(), trials.without(model, place), model, trials.options().rules));
    selection.groups.push_back(group_of(trials, model, place));
  }
}

std::string reason_against(const Trials& trials, const Fit& model, const Fit& with) {
  const AcceptanceRules& rules = trials.options().rules;
  const Gain gain = with.is_valid ? gain_of(trials.fitter(), model, with, rules) : Gain{};
  const std::string reason = objection(with, gain, rules);
  return reason.empty() ? "another effect takes its place" : reason;
}

/// Why everything else stayed out: of each effect, the variant that leaves least.
void add_rejected(const Trials& trials, const std::set<std::string>& named, Selection& selection) {
  std::map<std::string, std::pair<double, std::string>> reasons;
  for (const std::size_t v : trials.options().variants) {
    const std::string& effect = trials.variant(v).effect;
    if (named.count(effect) != 0 || !trials.may_join(selection.model.members, v)) continue;
    const Fit with = trials.fitter().fit(plus_one(selection.model.members, v));
    const double loss = with.is_valid ? with.loss : std::numeric_limits<double>::max();
    const auto known = reasons.find(effect);
    if (known != reasons.end() && known->second.first <= loss) continue;
    reasons[effect] = {loss, reason_against(trials, selection.model, with)};
  }
  for (auto& [effect, reason] : reasons) {
    selection.rejected.push_back({effect, std::move(reason.second)});
  }
}

}  // namespace

Selection search(const Fitter& fitter, const SearchOptions& options) {
  const Trials trials(fitter, options);
  Selection selection;
  selection.empty = selection.model = trials.empty();
  if (!selection.empty.is_valid) return selection;
  put_in_order(trials, best_model(trials), selection);
  add_gains(trials, selection);
  std::set<std::string> named;
  for (const Group& group : selection.groups) {
    named.insert(group.effects.begin(), group.effects.end());
  }
  std::erase_if(selection.groups, [](const Group& group) { return group.effects.size() < 2; });
  add_rejected(trials, named, selection);
  return selection;
}

}  // namespace torquewright::identification
