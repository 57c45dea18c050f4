// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// Position of one joint at the rows of a run, in the order of time.
struct Travel {
  const std::vector<double>& time_s;
  const std::vector<double>& position;
  double least_step = 0.0;  ///< Of the position between two rows that differ; 0: none was seen.
};

/// Whether the last `repeats` rows, which say the same as the row before them, are late words of a
/// recorder rather than rest: the position goes on behind them as it came, as if it had moved all
/// the time. `next`: the row behind them.
bool are_stale(const Travel& travel, std::size_t repeats, double next_s, double next_position);

}  // namespace torquewright::identification
