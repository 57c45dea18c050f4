// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/sample_step.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::identification {

double half_a_step_s(const std::vector<Signals>& signals) {
  double shortest_s = INFINITY;
  for (const Signals& each : signals) {
    if (each.step_s > 0.0) shortest_s = std::min(shortest_s, each.step_s);
  }
  return std::isfinite(shortest_s) ? 0.5 * shortest_s : 0.0;
}

}  // namespace torquewright::identification
