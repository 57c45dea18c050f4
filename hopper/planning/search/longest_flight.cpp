// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/search/longest_flight.hpp"

#include <algorithm>

namespace torquewright::hopper {

const PlannedPhase* longest_flight(const PlannedMotion& motion) {
  const PlannedPhase* longest = nullptr;
  for (const PlannedPhase& phase : motion.phases) {
    if (!phase.flies() || phase.instants.empty()) continue;
    if (longest != nullptr &&
        phase.end_s() - phase.begin_s() <= longest->end_s() - longest->begin_s()) {
      continue;
    }
    longest = &phase;
  }
  return longest;
}

std::optional<double> rise_of(const PlanResult& result) {
  if (!result.check || result.check->flights.empty()) return std::nullopt;
  const auto& flights = result.check->flights;
  return std::max_element(flights.begin(), flights.end(),
                          [](const Flight& one, const Flight& other) {
                            return one.until_s - one.from_s < other.until_s - other.from_s;
                          })
      ->rise_m;
}

}  // namespace torquewright::hopper
