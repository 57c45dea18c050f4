// SPDX-License-Identifier: Apache-2.0
#include "identification/confident_search.hpp"

#include <algorithm>
#include <set>

#include "identification/acceptance_tests.hpp"
#include "identification/trials.hpp"

namespace torquewright::identification {
namespace {

constexpr int kMostSearches = 5;

const std::string& effect_of(const EquationFit& fit, std::size_t variant) {
  return fit.equation().dictionary.variants[variant].effect;
}

std::set<std::string> effects_of(const EquationFit& fit, const Selection& selection) {
  std::set<std::string> effects;
  for (const std::size_t member : selection.model.members) effects.insert(effect_of(fit, member));
  return effects;
}

/// Paths and gains of a model whose members stand in the order of their gain.
void fill_path(const Fitter& fitter, const Members& kept, Selection& less) {
  Members members;
  for (std::size_t m = 0; m < kept.size(); ++m) {
    members.push_back(kept[m]);
    less.path.push_back(fitter.fit(members));
    less.gains.push_back(gain_of(fitter, fitter.fit_unlimited(less_one(kept, m)), less.model));
  }
}

/// The same selection with fewer members.
Selection reduced_to(const EquationFit& fit, const Members& kept, const Selection& selection) {
  Selection less;
  less.empty = selection.empty;
  less.rejected = selection.rejected;
  less.model = fit.fitter().fit(kept);
  if (!less.model.is_valid) {
    less.model = selection.empty;
    return less;
  }
  fill_path(fit.fitter(), kept, less);
  for (const Group& group : selection.groups) {
    const auto at = std::find(kept.begin(), kept.end(), selection.model.members[group.member]);
    if (at == kept.end()) continue;
    less.groups.push_back({static_cast<std::size_t>(at - kept.begin()), group.effects});
  }
  return less;
}

/// Members that fail no acceptance test, beside none that does.
Selection sure_part(const EquationFit& fit, const std::vector<ResidualStructure>& before,
                    Selection selection, std::vector<std::string> of_member) {
  const auto has_failed = [](const std::string& each) { return !each.empty(); };
  while (std::any_of(of_member.begin(), of_member.end(), has_failed)) {
    Members kept;
    for (std::size_t m = 0; m < of_member.size(); ++m) {
      if (of_member[m].empty()) kept.push_back(selection.model.members[m]);
    }
    selection = reduced_to(fit, kept, selection);
    of_member = failed_acceptance_tests(fit, selection, before);
  }
  return selection;
}

/// The effects of members that fail an acceptance test; which one joins the list.
std::set<std::string> collect_failed(const EquationFit& fit, const Selection& selection,
                                     const std::vector<std::string>& of_member,
                                     std::vector<Rejection>& failed) {
  std::set<std::string> effects;
  for (std::size_t m = 0; m < of_member.size(); ++m) {
    if (of_member[m].empty()) continue;
    const std::string& effect = effect_of(fit, selection.model.members[m]);
    effects.insert(effect);
    failed.push_back({effect, "it lowers the error, but " + of_member[m]});
  }
  return effects;
}

}  // namespace

ConfidentSelection confident_search(const EquationFit& fit,
                                    const std::vector<ResidualStructure>& before,
                                    const std::vector<std::string>& settled) {
  SearchOptions options;
  options.target_is_motor_side = fit.equation().target_is_motor_side;
  options.is_free_load = fit.equation().is_free_load;
  options.variants = fit.excited_variants();
  std::erase_if(options.variants, [&](std::size_t v) {
    return std::find(settled.begin(), settled.end(), effect_of(fit, v)) != settled.end();
  });
  std::vector<Rejection> failed;
  for (int round = 1;; ++round) {
    Selection selection = search(fit.fitter(), options);
    const std::vector<std::string> of_member = failed_acceptance_tests(fit, selection, before);
    const auto left_out = collect_failed(fit, selection, of_member, failed);
    const bool is_sure = left_out.empty();
    if (is_sure || round == kMostSearches || left_out.size() == effects_of(fit, selection).size()) {
      if (!is_sure) selection = sure_part(fit, before, selection, of_member);
      selection.rejected.insert(selection.rejected.end(), failed.begin(), failed.end());
      return {std::move(selection), !is_sure};
    }
    std::erase_if(options.variants,
                  [&](std::size_t v) { return left_out.count(effect_of(fit, v)) != 0; });
  }
}

}  // namespace torquewright::identification
