// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "identification/acceptance_tests/acceptance_test.hpp"

namespace torquewright::identification {
namespace {

constexpr double kLeastExplained = 0.6;  ///< Share of what is explainable.

}  // namespace

std::string insufficient_share(const EquationFit& fit, const Selection& selection,
                               const std::vector<ResidualStructure>& /*before*/) {
  const Fit& empty = selection.empty;
  const Fit& model = selection.model;
  const double floor_loss = fit.floor_loss(model);
  const double explainable = empty.loss - floor_loss;
  const double explained = empty.loss - model.loss;
  if (explained >= kLeastExplained * explainable || model.loss <= kTestedFloors * floor_loss) {
    return "";
  }
  return fmt::format(
      "with it only {:.0f} % of what noise does not explain is gone; a name asks for {:.0f} %",
      100.0 * explained / explainable, 100.0 * kLeastExplained);
}

}  // namespace torquewright::identification
