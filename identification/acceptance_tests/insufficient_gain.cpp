// SPDX-License-Identifier: Apache-2.0
#include "identification/acceptance.hpp"
#include "identification/acceptance_tests/acceptance_test.hpp"

namespace torquewright::identification {

std::string insufficient_gain(const EquationFit& fit, const Fit& model, std::size_t member,
                              const std::vector<ResidualStructure>& /*left*/) {
  const Fitter& fitter = fit.fitter();
  Members members = model.members;
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(member));
  const Fit without = fitter.fit_unlimited(members);
  if (!without.is_valid) return "";
  const AcceptanceRules rules = rules_for(fitter.dictionary(), members, model.members);
  return objection(model, gain_of(fitter, without, model, rules), rules);
}

}  // namespace torquewright::identification
