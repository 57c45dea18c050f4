// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "identification/acceptance_tests/acceptance_test.hpp"

namespace torquewright::identification {
namespace {

constexpr double kConfirmed = 0.04;  ///< Share of the held-out error that names take away.

}  // namespace

std::string unconfirmed_held_out(const EquationFit& fit, const Fit& model, std::size_t member,
                                 const std::vector<ResidualStructure>& /*left*/) {
  const Fitter& fitter = fit.fitter();
  if (fitter.samples(true) == 0.0) return "";
  Members members = model.members;
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(member));
  const Fit without = fitter.fit_unlimited(members);
  if (!without.is_valid) return "";
  const double before = fitter.loss_on(without, true), after = fitter.loss_on(model, true);
  if (before - after > kConfirmed * before) return "";
  return fmt::format(
      "in the runs held out from everything it changes the squared error by {:+.0f} % only",
      100.0 * (after - before) / before);
}

std::string unconfirmed_held_out_together(const EquationFit& fit, const Selection& selection,
                                          const std::vector<ResidualStructure>& /*before*/) {
  const Fitter& fitter = fit.fitter();
  const double samples = fitter.samples(true);
  if (samples == 0.0) return "";
  const double before = fitter.loss_on(selection.empty, true);
  const double after = fitter.loss_on(selection.model, true);
  if (after <= kTestedFloors * fitter.noise_loss(selection.model) * samples) return "";
  if (before - after > kConfirmed * before) return "";
  return fmt::format(
      "in the runs held out from everything all names together change the squared error by "
      "{:+.0f} %",
      100.0 * (after - before) / before);
}

}  // namespace torquewright::identification
