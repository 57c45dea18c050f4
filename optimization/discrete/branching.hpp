// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "optimization/expressions/box.hpp"

namespace torquewright::optimization {

/// A division of a box into two: the first half has at most `value` in `variable`.
struct Split {
  std::size_t variable;
  std::int64_t value;
};

/// Splits at the middle of the widest range. The box must hold more than one point.
inline Split choose_split(const Box& box) {
  const auto widest = std::max_element(
      box.begin(), box.end(), [](const Range& a, const Range& b) { return a.size() < b.size(); });
  return {static_cast<std::size_t>(widest - box.begin()), widest->lower + (widest->size() - 1) / 2};
}

inline Box first_half(Box box, const Split& split) {
  box[split.variable].upper = split.value;
  return box;
}

inline Box second_half(Box box, const Split& split) {
  box[split.variable].lower = split.value + 1;
  return box;
}

}  // namespace torquewright::optimization
