// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// A group of runs whose evidence is weighed together.
struct RunGroup {
  std::size_t number = 0;  ///< Number from 0; groups to fit and groups held out are numbered apart.
  bool is_held_out = false;
};

/// Most groups that a long log is weighed in (docs/derivations/identification.md section 9).
constexpr std::size_t kMostGroups = 400;

/// Returns the group of each run: runs of one name are one group. Where a log that is not in memory
/// holds more names than kMostGroups, neighbours share one. Requires that the hold-out is chosen.
std::vector<RunGroup> run_groups(const Log& log);

/// Number of run names per group; 1 where none share.
double runs_per_group(const Log& log);

}  // namespace torquewright::identification
