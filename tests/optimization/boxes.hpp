// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimization/expressions/box.hpp"
#include "tests/optimization/true_values.hpp"
#include "tests/oracles/dice.hpp"

namespace torquewright::optimization {

using oracles::Dice;
using RealPoint = std::vector<Rational>;

/// Ranges within least..most, of up to `widest` values.
inline Box draw_box(Dice& dice, std::size_t variables, std::int64_t least, std::int64_t most,
                    std::int64_t widest) {
  Box box;
  for (std::size_t i = 0; i < variables; ++i) {
    const std::int64_t lower = dice.between(least, most);
    box.push_back({lower, std::min(most, lower + dice.between(0, widest - 1))});
  }
  return box;
}

/// Anywhere in the box, corners and sides included; eighths, so that doubles hold it exactly.
inline std::vector<double> draw_inside(Dice& dice, const Box& box) {
  std::vector<double> point;
  for (const Range& range : box) {
    point.push_back(static_cast<double>(dice.between(8 * range.lower, 8 * range.upper)) / 8.0);
  }
  return point;
}

inline RealPoint exactly(const std::vector<double>& point) { return {point.begin(), point.end()}; }

inline std::vector<RealPoint> corners(const Box& box) {
  std::vector<RealPoint> result{{}};
  for (const Range& range : box) {
    std::vector<RealPoint> longer;
    for (const RealPoint& corner : result) {
      for (const std::int64_t end : {range.lower, range.upper}) {
        longer.push_back(corner);
        longer.back().emplace_back(end);
      }
    }
    result = std::move(longer);
  }
  return result;
}

}  // namespace torquewright::optimization
