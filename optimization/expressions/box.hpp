// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "optimization/expressions/interval.hpp"

namespace torquewright::optimization {

/// The integers lower..upper; empty if upper < lower.
struct Range {
  std::int64_t lower = 0;
  std::int64_t upper = -1;

  std::int64_t size() const { return upper < lower ? 0 : upper - lower + 1; }
  bool contains(std::int64_t value) const { return lower <= value && value <= upper; }
  /// Returns the range as an interval of reals. Bounds are far below 2^53, so this is exact.
  Interval interval() const { return {static_cast<double>(lower), static_cast<double>(upper)}; }
  friend bool operator==(const Range&, const Range&) = default;
};

/// One range for each variable of a problem, in its order.
using Box = std::vector<Range>;

/// Number of integer points in the box; a very large number stands for anything larger.
inline double point_count(const Box& box) {
  double count = 1.0;
  for (const Range& range : box) count *= static_cast<double>(range.size());
  return count;
}

}  // namespace torquewright::optimization
