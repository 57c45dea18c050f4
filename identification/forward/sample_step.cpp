// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/sample_step.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::identification {

double half_a_step_s(const std::vector<Signals>& signals) {
  double shortest_s = INFINITY;
  for (const Signals& each : signals) {
    if (each.sample_step_s > 0.0) shortest_s = std::min(shortest_s, each.sample_step_s);
  }
  return std::isfinite(shortest_s) ? 0.5 * shortest_s : 0.0;
}

void add_instant(double half_a_step_s, double LogErrors::*instant, ForwardEquation& equation) {
  if (half_a_step_s == 0.0) return;
  const std::size_t index = equation.always.size();
  equation.always.push_back({kInstant, -half_a_step_s, half_a_step_s, half_a_step_s, false});
  equation.always_start.push_back(0.0);
  equation.apply_always = [instant, index, before = equation.apply_always](
                              std::span<const double> values, Hypothesis& hypothesis) {
    before(values, hypothesis);
    hypothesis.log.*instant = values[index];
  };
}

}  // namespace torquewright::identification
