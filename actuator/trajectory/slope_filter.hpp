// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace torquewright::actuator {

/// Values of a row at one time.
struct Row {
  double time_s = 0.0;
  std::vector<double> values;
};

/// Passes rows on, each with time derivatives of some of its values: the slope, at the row's own
/// time, of the parabola through it and its two neighbours (at the ends: through the first or last
/// three rows). Exact for parabolas, second order in the step, on uneven steps as well. Two rows
/// yield their difference quotient, a single one yields slopes of 0. Holds three rows.
/// docs/derivations/check.md eq. (1).
class SlopeFilter {
 public:
  /// values[to] becomes the slope of values[from].
  struct Pair {
    std::size_t from;
    std::size_t to;
  };
  using Sink = std::function<void(const Row&)>;

  SlopeFilter(std::vector<Pair> pairs, Sink sink);

  /// Adds a row. Requires a later time than the row before, and as many values.
  void push(const Row& row);

  /// Passes on the last rows; called after the last push().
  void finish();

 private:
  void emit(std::size_t index);

  std::vector<Pair> pairs_;
  Sink sink_;
  std::array<Row, 3> rows_;
  std::size_t held_ = 0;
  bool is_first_emitted_ = false;
};

}  // namespace torquewright::actuator
