// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "optimization/expressions/box.hpp"

namespace torquewright::optimization {

/// Boxes of at most so many points are enumerated. A choice of ours.
inline constexpr double kSmallBoxPoints = 64.0;

inline bool is_small(const Box& box) { return point_count(box) <= kSmallBoxPoints; }

/// Calls `visit(std::span<const std::int64_t>)` for every point of a box, the last variable
/// fastest.
template <class Visit>
void for_each_point(const Box& box, Visit visit) {
  if (point_count(box) == 0.0) return;
  std::vector<std::int64_t> point;
  for (const Range& range : box) point.push_back(range.lower);
  for (;;) {
    visit(std::span<const std::int64_t>(point));
    std::size_t i = box.size();
    while (i > 0 && point[i - 1] == box[i - 1].upper) {
      point[i - 1] = box[i - 1].lower;
      --i;
    }
    if (i == 0) return;
    ++point[i - 1];
  }
}

}  // namespace torquewright::optimization
