// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "optimization/expressions/interval.hpp"
#include "tests/optimization/true_values.hpp"
#include "tests/oracles/dice.hpp"

namespace torquewright::optimization {

using oracles::Dice;

/// A double with all 53 bits drawn; now and then a small whole number or zero.
inline double draw_number(Dice& dice, std::int64_t greatest_exponent) {
  if (dice.chance(20)) return static_cast<double>(dice.between(-3, 3));
  const auto bits = static_cast<double>(dice.between(-(1LL << 53), 1LL << 53));
  return std::ldexp(bits,
                    static_cast<int>(dice.between(-greatest_exponent, greatest_exponent)) - 53);
}

/// Every fifth is a point.
inline Interval draw_interval(Dice& dice, std::int64_t greatest_exponent) {
  const double a = draw_number(dice, greatest_exponent);
  const double b = dice.chance(20) ? a : draw_number(dice, greatest_exponent);
  return {std::min(a, b), std::max(a, b)};
}

inline Interval draw_between(Dice& dice, double least, double greatest) {
  const auto draw = [&] {
    return least + (greatest - least) * static_cast<double>(dice.between(0, 1 << 30)) * 0x1p-30;
  };
  const double a = draw(), b = draw();
  return {std::min(a, b), std::max(a, b)};
}

/// Both ends, and some members between them, as exact fractions.
inline std::vector<Rational> members(const Interval& interval) {
  const Rational lower(interval.lower), width = Rational(interval.upper) - lower;
  return {lower, lower + width / 7, lower + width / 2, lower + width * 6 / 7, lower + width};
}

}  // namespace torquewright::optimization
