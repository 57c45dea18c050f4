// SPDX-License-Identifier: Apache-2.0
#include "identification/acceptance_tests.hpp"

#include "identification/acceptance_tests/acceptance_test.hpp"

namespace torquewright::identification {
namespace {

constexpr AcceptanceTestOfAll* kTestsOfAll[] = {insufficient_share, coordinate_table_explains_more,
                                                unconfirmed_held_out_together};
constexpr AcceptanceTestOfMember* kTestsOfMember[] = {
    unconfirmed_held_out,          insufficient_gain, parameter_scatter, harmonic_comb,
    residual_along_own_coordinate, varying_amplitude};

std::string failure_of_all(const EquationFit& fit, const Selection& selection,
                           const std::vector<ResidualStructure>& before) {
  for (AcceptanceTestOfAll* const test : kTestsOfAll) {
    const std::string reason = test(fit, selection, before);
    if (!reason.empty()) return reason;
  }
  return "";
}

std::string failure_of_member(const EquationFit& fit, const Fit& model, std::size_t member,
                              const std::vector<ResidualStructure>& left) {
  for (AcceptanceTestOfMember* const test : kTestsOfMember) {
    const std::string reason = test(fit, model, member, left);
    if (!reason.empty()) return reason;
  }
  return "";
}

}  // namespace

std::vector<std::string> failed_acceptance_tests(const EquationFit& fit, const Selection& selection,
                                                 const std::vector<ResidualStructure>& before) {
  const Fit& model = selection.model;
  if (model.members.empty()) return {};
  const std::string of_all = failure_of_all(fit, selection, before);
  std::vector<std::string> of_member(model.members.size(), of_all);
  if (!of_all.empty()) return of_member;
  const std::vector<ResidualStructure> left = fit.structure(model);
  for (std::size_t m = 0; m < of_member.size(); ++m) {
    of_member[m] = failure_of_member(fit, model, m, left);
  }
  return of_member;
}

}  // namespace torquewright::identification
