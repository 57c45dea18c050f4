// SPDX-License-Identifier: Apache-2.0
// Expressions, laid out and evaluated. Oracle: the same formula, written by hand in exact fractions
// (MPFR where there are roots or angles).
#include "optimization/expressions/formula.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "optimization/expressions/apply.hpp"
#include "tests/optimization/random_intervals.hpp"

namespace torquewright::optimization {
namespace {

using Point = std::vector<std::int64_t>;

struct Example {
  std::string name;
  Expression expression;
  std::function<Rational(const Rational& x, const Rational& y)> exact;
  Interval x, y;  ///< Where it is defined.
};

std::vector<Example> examples() {
  using R = Rational;
  const Expression x = Expression::variable(0), y = Expression::variable(1);
  const Expression third = Expression(R(1, 3));
  return {
      {"polynomial",
       third * x * y - square(x) + 2.5,
       [](const R& a, const R& b) -> R { return a * b / 3 - a * a + R(5, 2); },
       {-9, 9},
       {-9, 9}},
      {"rational",
       (x + 2.0 * y) / (y - third) - x / 7.0,
       [](const R& a, const R& b) -> R { return (a + 2 * b) / (b - R(1, 3)) - a / 7; },
       {-9, 9},
       {1, 9}},
      {"square_over",
       square_over(x - 1.0, 2.0 * y + third),
       [](const R& a, const R& b) -> R { return (a - 1) * (a - 1) / (2 * b + R(1, 3)); },
       {-9, 9},
       {0, 9}},
      {"extremes",
       max(abs(x - y), min(x, -third)) - abs(-y),
       [](const R& a, const R& b) -> R {
         return std::max<R>(::abs(R(a - b)), std::min<R>(a, R(-1, 3))) - ::abs(b);
       },
       {-9, 9},
       {-9, 9}},
      {"root",
       sqrt(square(x) + third) * y,
       [](const R& a, const R& b) -> R { return true_sqrt(a * a + R(1, 3)) * b; },
       {-9, 9},
       {-9, 9}},
      {"angles",
       asin(x / 10.0) - acos(y / 10.0) + atan(x * y),
       [](const R& a, const R& b) -> R {
         return true_asin(a / 10) - true_acos(b / 10) + true_atan(a * b);
       },
       {-10, 10},
       {-10, 10}},
      {"angles of constants",
       sin(third) * x + cos(third) * y - tan(Expression(R(2, 7))),
       [](const R& a, const R& b) -> R {
         return true_sin(R(1, 3)) * a + true_cos(R(1, 3)) * b - true_tan(R(2, 7));
       },
       {-9, 9},
       {-9, 9}},
      {"pi",
       Expression::pi() * square(y) - x,
       [](const R& a, const R& b) -> R { return true_pi() * b * b - a; },
       {-9, 9},
       {-9, 9}},
  };
}

Point draw_point(Dice& dice, const Example& example) {
  const auto draw = [&](const Interval& range) {
    return dice.between(static_cast<std::int64_t>(range.lower),
                        static_cast<std::int64_t>(range.upper));
  };
  return {draw(example.x), draw(example.y)};
}

TEST(Formula, PointsAgreeInDoublesAndIn256Bits) {
  Dice dice(41);
  for (const Example& example : examples()) {
    const Formula formula(example.expression);
    for (int trial = 0; trial < 200; ++trial) {
      const Point point = draw_point(dice, example);
      const Rational exact = example.exact(Rational(point[0]), Rational(point[1]));
      ASSERT_TRUE(encloses(formula.at(point), exact)) << example.name;
      ASSERT_TRUE(agrees(formula.precisely_at(point), exact)) << example.name;
      const Interval at = formula.at(point);
      // A dozen roundings of numbers up to 1000; asin is steep near 1.
      ASSERT_LT(at.upper - at.lower, 1e-6) << example.name;
    }
  }
}

TEST(Formula, BoxesEncloseTheirPoints) {
  Dice dice(42);
  for (const Example& example : examples()) {
    const Formula formula(example.expression);
    for (int trial = 0; trial < 100; ++trial) {
      const Interval x = draw_between(dice, example.x.lower, example.x.upper);
      const Interval y = draw_between(dice, example.y.lower, example.y.upper);
      const Interval range = formula.over(std::vector<Interval>{x, y});
      for (const Rational& a : members(x)) {
        for (const Rational& b : members(y)) {
          ASSERT_TRUE(encloses(range, example.exact(a, b))) << example.name;
        }
      }
    }
  }
}

// A shared part is one step: 2^60 evaluations would not end.
TEST(Formula, SharedPartsAreEvaluatedOnce) {
  Expression doubled = Expression::variable(0);
  for (int i = 0; i < 50; ++i) doubled = doubled + doubled;
  EXPECT_TRUE(agrees(Formula(doubled).precisely_at(Point{3}), Rational(3) * (Rational(1) << 50)));
}

TEST(Expression, OperationsOnConstantsAreCarriedOutPrecisely) {
  const Expression third = Expression(1.0) / Expression(3.0);
  ASSERT_TRUE(third.is_constant());
  EXPECT_TRUE(agrees(third.node().value, Rational(1, 3)));
  EXPECT_TRUE(agrees(sqrt(third).node().value, true_sqrt(Rational(1, 3))));
  EXPECT_TRUE(agrees(square_over(third, 2.0).node().value, Rational(1, 18)));
  EXPECT_TRUE(agrees(max(third, 0.25).node().value, Rational(1, 3)));
  EXPECT_TRUE(agrees((third - 1.0).node().value, Rational(-2, 3)));
  EXPECT_FALSE((third + Expression::variable(0)).is_constant());
}

TEST(Expression, BetweenEnclosesBothBounds) {
  const Formula formula(Expression::between(Rational(1, 3), Rational(2, 3)) *
                        Expression::variable(0));
  EXPECT_TRUE(encloses(formula.at(Point{3}), 1) && encloses(formula.at(Point{3}), 2));
  EXPECT_FALSE(encloses(formula.at(Point{3}), Rational(9, 10)));
}

TEST(Expression, AnglesOfVariablesAreRefused) {
  const Expression x = Expression::variable(0);
  EXPECT_THROW(sin(x), std::logic_error);
  EXPECT_THROW(cos(x), std::logic_error);
  EXPECT_THROW(tan(x), std::logic_error);
}

TEST(Apply, LeavesAreNoOperations) {
  EXPECT_THROW(apply(Operation::kConstant, Interval(1), Interval(1)), std::logic_error);
  EXPECT_THROW(apply(Operation::kVariable, Interval(1), Interval(1)), std::logic_error);
}

// Outside a domain there is no value, in doubles as in 256 bits.
TEST(Formula, NowhereOutsideItsDomain) {
  const Formula formula(1.0 + sqrt(Expression::variable(0)));
  EXPECT_TRUE(is_nowhere(formula.at(Point{-1})));
  EXPECT_TRUE(formula.precisely_at(Point{-1}).is_nowhere());
  EXPECT_TRUE(agrees(formula.precisely_at(Point{0}), 1));
}

}  // namespace
}  // namespace torquewright::optimization
