// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// Of a channel, at most: what its steps, or two of them that follow one another, differ by least.
/// All are multiples of what it counts in, but for the rounding of what is written.
class Resolution {
 public:
  /// `digit`: the last that is written.
  void add(double step, double digit);
  double least() const { return least_; }  ///< 0: not yet known.

 private:
  void note(double difference, double rounding);

  double last_step_ = 0.0;
  double least_ = 0.0;
};

/// Position of one joint at the rows of a run, in the order of time.
struct Travel {
  const std::vector<double>& time_s;
  const std::vector<double>& position;
  double resolution = 0.0;  ///< Of the position, at most; 0: not yet known.
};

/// Whether the last `repeats` rows, which say the same as the row before them, are late words of a
/// recorder rather than rest: the position goes on behind them as it came, as if it had moved all
/// the time. `next`: the row behind them.
bool are_stale(const Travel& travel, std::size_t repeats, double next_s, double next_position);

}  // namespace torquewright::identification
