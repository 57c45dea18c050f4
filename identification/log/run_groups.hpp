// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Whose evidence a run is weighed with.
struct RunGroup {
  std::size_t number = 0;  ///< From 0; those to fit and those held out are numbered apart.
  bool is_held_out = false;
};

/// A long log is weighed in no more groups.
constexpr std::size_t kMostGroups = 400;

/// Of each run: runs of one name are one group. Where a log that is not in memory holds more names
/// than kMostGroups, neighbours share one. Requires the hold-out to be chosen.
std::vector<RunGroup> run_groups(const Log& log);

/// Runs, by name, for each group; 1 where none share.
double runs_per_group(const Log& log);

}  // namespace torquewright::identification
