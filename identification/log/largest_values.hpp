// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// The upper end of values that come one by one, without keeping the others: exact quantiles near
/// one in little memory.
class LargestValues {
 public:
  /// Of `most_values` at most, for quantiles of `least_share` (0...1) and above.
  LargestValues(std::size_t most_values, double least_share);

  void add(double value);
  std::size_t count() const { return count_; }

  /// What optimization::nearest_quantile() gives of all values. Requires some, and a share no less
  /// than the least.
  double quantile(double share) const;

 private:
  std::size_t kept_;
  std::size_t count_ = 0;
  std::vector<double> heap_;  ///< The least of them first.
};

}  // namespace torquewright::identification
