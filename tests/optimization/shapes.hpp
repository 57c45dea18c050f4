// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optimization/expressions/expression.hpp"
#include "tests/optimization/boxes.hpp"

namespace torquewright::optimization {

/// A formula in x, y, z that the relaxation knows something of, and the same in exact fractions.
/// Divisors are positive where all variables lie in 0..30.
struct Shape {
  std::string name;
  Expression expression;
  std::function<Rational(const RealPoint&)> exact;
};

inline std::vector<Shape> shapes() {
  using R = Rational;
  const Expression x = Expression::variable(0), y = Expression::variable(1),
                   z = Expression::variable(2);
  const Expression third = Expression(R(1, 3));
  return {
      {"affine", 2.0 * x - third * y + z - 5.0,
       [](const RealPoint& p) -> R { return 2 * p[0] - p[1] / 3 + p[2] - 5; }},
      {"minus a square", third - square(x - 2.0 * y),
       [](const RealPoint& p) -> R { return R(1, 3) - (p[0] - 2 * p[1]) * (p[0] - 2 * p[1]); }},
      {"square", square(x - y + z) * third,
       [](const RealPoint& p) -> R {
         const R u = p[0] - p[1] + p[2];
         return u * u / 3;
       }},
      {"minus a square over", y - third * square_over(x - 7.0, y + 2.0 * z + 1.0),
       [](const RealPoint& p) -> R {
         return p[1] - (p[0] - 7) * (p[0] - 7) / (p[1] + 2 * p[2] + 1) / 3;
       }},
      {"square over", square_over(x - 7.0, y + 2.0 * z + 1.0) - z,
       [](const RealPoint& p) -> R {
         return (p[0] - 7) * (p[0] - 7) / (p[1] + 2 * p[2] + 1) - p[2];
       }},
      {"mixed", -(square(x) - 2.0 * square(y)) - (square_over(z, x + 1.0) - third * square(z)),
       [](const RealPoint& p) -> R {
         return -(p[0] * p[0] - 2 * p[1] * p[1]) - (p[2] * p[2] / (p[0] + 1) - p[2] * p[2] / 3);
       }},
      {"other parts", x * y - abs(z - 4.0) - 2.0 / (x + 1.0) - 0.5 * square(x * y),
       [](const RealPoint& p) -> R {
         return p[0] * p[1] - ::abs(R(p[2] - 4)) - 2 / (p[0] + 1) - p[0] * p[1] * p[0] * p[1] / 2;
       }},
      {"negative factors", -3.0 * (square(x) * -0.5 + third * square_over(y, z + 1.0)) / -2.0,
       [](const RealPoint& p) -> R {
         return R(3, 2) * (-p[0] * p[0] / 2 + p[1] * p[1] / (p[2] + 1) / 3);
       }},
  };
}

}  // namespace torquewright::optimization
