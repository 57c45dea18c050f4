// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/search/least_minima.hpp"

namespace torquewright::gearbox {

/// Limits of the work for a standing.
struct StandingOptions {
  /// Most boxes for each of its three searches.
  std::int64_t max_boxes = std::numeric_limits<std::int64_t>::max();
  std::function<bool()> should_stop = [] { return false; };
  /// What is being sought, boxes looked at, and designs found that count.
  std::function<void(const char* sought, std::int64_t boxes, std::int64_t found)> report =
      [](const char*, std::int64_t, std::int64_t) {};
};

/// Place of a design among all others.
struct Standing {
  bool is_settled = false;  ///< Rank, ties and optimal_when are final; else the options ended them.
  std::optional<std::int64_t>
      rank;                  ///< 1 + feasible designs that are better; absent: it is not one.
  std::vector<Design> ties;  ///< Feasible designs that are exactly as good.
  std::vector<OptimalWhen> optimal_when;  ///< Empty where it breaks more than minima and clearance.
  /// Best objective of any feasible design; absent: none, or not settled.
  std::optional<double> best_objective;
  std::optional<std::int64_t> feasible_count;  ///< Absent: not settled.
};

/// Ranks a design among all feasible ones, and finds for which minima and carrier clearance it
/// would be the optimum. Boxes in which nothing is as good are never opened.
Standing standing_of(const Problem& problem, const Design& design, const StandingOptions& options);

}  // namespace torquewright::gearbox
