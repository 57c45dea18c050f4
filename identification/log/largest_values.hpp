// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// Keeps the upper end of values that come one by one: exact quantiles near one in little memory.
class LargestValues {
 public:
  /// Makes room for at most `most_values` values in all, and for quantiles of `least_share` (0...1)
  /// and above.
  LargestValues(std::size_t most_values, double least_share);

  void add(double value);
  std::size_t count() const { return count_; }

  /// Returns what optimization::nearest_quantile() gives for all values. Requires at least one
  /// value, and a share no less than `least_share`.
  double quantile(double share) const;

 private:
  std::size_t kept_;
  std::size_t count_ = 0;
  std::vector<double> heap_;  ///< The kept values as a heap, the least of them first.
};

}  // namespace torquewright::identification
