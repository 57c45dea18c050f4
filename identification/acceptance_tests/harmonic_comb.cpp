// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/acceptance_tests/acceptance_test.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kFewestOfASpot = 4;  ///< Waves of friction that are multiples of one.

}  // namespace

std::string harmonic_comb(const EquationFit& fit, const Fit& model, std::size_t member,
                          const std::vector<ResidualStructure>& /*left*/) {
  const Fitter& fitter = fit.fitter();
  const Dictionary& dictionary = fitter.dictionary();
  const std::string effect = "position_dependent_friction";
  if (dictionary.variants[model.members[member]].effect != effect) return "";
  std::vector<double> orders;
  for (const std::size_t each : model.members) {
    if (dictionary.variants[each].effect == effect)
      orders.push_back(dictionary.variants[each].order);
  }
  const double lowest = *std::min_element(orders.begin(), orders.end());
  const bool is_comb = std::all_of(orders.begin(), orders.end(), [&](double order) {
    return std::abs(order / lowest - std::round(order / lowest)) < 1e-6;
  });
  if (orders.size() < kFewestOfASpot || !is_comb) return "";
  return fmt::format(
      "its {} waves are multiples of order {:g}: friction of one spot, not of an order",
      orders.size(), lowest);
}

}  // namespace torquewright::identification
