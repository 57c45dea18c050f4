// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/run.hpp"

namespace torquewright::identification {

/// Estimates a channel's resolution from above: the least difference of its steps, or of two
/// successive ones. All steps are multiples of the resolution, but for the rounding of what is
/// written.
class Resolution {
 public:
  /// Adds a step; `digit` is the size of the last written digit.
  void add(double step, double digit);
  double least() const { return least_; }  ///< 0: not yet known.

 private:
  void note(double difference, double rounding);

  double last_step_ = 0.0;
  double least_ = 0.0;
};

/// Positions of one joint at the rows of a run, in the order of time.
struct Travel {
  const std::vector<double>& time_s;
  const std::vector<double>& position;
  double resolution = 0.0;  ///< Resolution of the position, at most; 0: not yet known.
};

/// Whether the last `repeats` rows, which repeat the row before them, are late words of a recorder
/// rather than rest: at `next_s`, the row behind them, the position has gone on as if it had moved
/// all the time.
bool are_stale(const Travel& travel, std::size_t repeats, double next_s, double next_position);

/// Leaves out rows of a recorder that asks faster than there is something new (rows repeat
/// throughout, not in a stretch of rest alone): those that repeat the row before in all channels
/// where new ones come at an even pace T, but for one each T, which is rest. What is new is then
/// taken for T apart, where times differ from that by no more than the recorder's own step and T is
/// more than two of these: it saw each up to a step late. Returns how many rows it left out; 0: no
/// such run.
std::size_t drop_polled(Run& run);

}  // namespace torquewright::identification
