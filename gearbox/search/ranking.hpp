// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/search/least_minima.hpp"

namespace torquewright::gearbox {

/// Where a design stands among all others.
struct Standing {
  bool is_complete = false;         ///< All designs were seen; else there were too many.
  std::int64_t feasible_count = 0;  ///< Designs that satisfy the whole problem.
  std::optional<std::int64_t>
      rank;                  ///< 1 + feasible designs that are better; absent: it is not one.
  std::vector<Design> ties;  ///< Feasible designs that are just as good.
  std::optional<double> best_objective;
  std::vector<OptimalWhen> optimal_when;  ///< Empty where it breaks more than minima and clearance.
};

/// Ranks a design among all feasible ones, and finds for which minima and carrier clearance it
/// would be the optimum: it sees every design that satisfies all other constraints.
Standing standing_of(const Problem& problem, const Design& design,
                     const std::function<bool()>& should_stop);

}  // namespace torquewright::gearbox
