// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hopper/planning/search/plan.hpp"
#include "hopper/trials/success_rate.hpp"

namespace torquewright::hopper {

/// A reserve, its plan, and how many trials of that plan succeed; none where there is no plan.
struct TriedReserve {
  double reserve = 0.0;
  PlanResult result;
  std::optional<TrialCounts> trials;
};

/// What a search for a reserve asks of whoever runs it.
struct ReserveTrials {
  /// The plan with that reserve.
  std::function<PlanResult(double reserve)> plan;
  /// How a plan fares in trials, the same draws each time.
  std::function<TrialCounts(const PlanResult& plan)> fare;
  std::function<bool()> should_stop = {};  ///< Asked behind the first; may be empty.
};

/// Reserves in ascending order, one at least, and the one with which most trials succeed: of
/// several the least, which costs least. `chosen` is none where no reserve has a plan.
struct ReserveChoice {
  std::vector<TriedReserve> tried;
  std::optional<std::size_t> chosen;
};

/// Tries reserves from `least` on in steps of 0.04 until one has no plan, then those half a step to
/// either side of the best and of that end. Throws what the two functions throw; a reserve of which
/// nothing would be left to plan with (with_reserve()) ends the ladder.
ReserveChoice search_reserve(double least, const ReserveTrials& trials);

}  // namespace torquewright::hopper
