// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/optimization/true_values.hpp"
#include "tests/oracles/dice.hpp"

namespace torquewright::optimization {

inline Rational draw_fraction(oracles::Dice& dice, std::int64_t greatest_numerator,
                              std::int64_t greatest_denominator) {
  const std::int64_t numerator = dice.between(-greatest_numerator, greatest_numerator);
  Rational value(static_cast<long>(numerator),
                 static_cast<long>(dice.between(1, greatest_denominator)));
  value.canonicalize();
  return value;
}

}  // namespace torquewright::optimization
