// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox {

/// For a range of alpha_min, the least minima that make a design the optimum: any minima that are
/// at least one of these (and at most the design's own teeth) do.
struct OptimalWhen {
  double clearance_above_rad = 0.0;  ///< alpha_min > this ...
  double clearance_up_to_rad = 0.0;  ///< ... and <= this.
  bool from_zero = false;            ///< The range starts at alpha_min = 0, that included.
  /// By free gear; 0: no minimum needed. Empty: no minima make it the optimum in this range.
  std::vector<std::vector<std::int64_t>> least_minima;
};

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
