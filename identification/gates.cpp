// SPDX-License-Identifier: Apache-2.0
#include "identification/gates.hpp"

#include "identification/doubts/doubts.hpp"

namespace torquewright::identification {
namespace {

constexpr DoubtOfAll* kDoubtsOfAll[] = {too_little, table_knows_more, not_confirmed_together};
constexpr DoubtOfOne* kDoubtsOfOne[] = {not_confirmed, no_longer_earned, scatter,
                                        is_a_spot,     left_along_own,   varying_amplitude};

std::string doubt_of_all(const EquationFit& fit, const Selection& selection,
                         const std::vector<Structure>& before) {
  for (DoubtOfAll* const doubt : kDoubtsOfAll) {
    const std::string reason = doubt(fit, selection, before);
    if (!reason.empty()) return reason;
  }
  return "";
}

std::string doubt_of_one(const EquationFit& fit, const Fit& model, std::size_t member,
                         const std::vector<Structure>& left) {
  for (DoubtOfOne* const doubt : kDoubtsOfOne) {
    const std::string reason = doubt(fit, model, member, left);
    if (!reason.empty()) return reason;
  }
  return "";
}

}  // namespace

std::vector<std::string> doubts(const EquationFit& fit, const Selection& selection,
                                const std::vector<Structure>& before) {
  const Fit& model = selection.model;
  if (model.members.empty()) return {};
  const std::string of_all = doubt_of_all(fit, selection, before);
  std::vector<std::string> of_member(model.members.size(), of_all);
  if (!of_all.empty()) return of_member;
  const std::vector<Structure> left = fit.structure(model);
  for (std::size_t m = 0; m < of_member.size(); ++m) {
    of_member[m] = doubt_of_one(fit, model, m, left);
  }
  return of_member;
}

}  // namespace torquewright::identification
