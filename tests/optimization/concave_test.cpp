// SPDX-License-Identifier: Apache-2.0
// Concave functions from above.
#include "optimization/expressions/concave.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/optimization/shapes.hpp"

namespace torquewright::optimization {
namespace {

constexpr std::size_t kShapeVariables = 3;

Box draw_shape_box(Dice& dice) { return draw_box(dice, kShapeVariables, 0, 30, 12); }

// Oracle: the formula in exact fractions, at corners and at random points.
TEST(ConcaveAbove, IsNowhereBelowTheFunction) {
  Dice dice(61);
  for (const Shape& shape : shapes()) {
    for (int trial = 0; trial < 80; ++trial) {
      const Box box = draw_shape_box(dice);
      const ConcaveForm form = concave_above(shape.expression, box);
      for (int sample = 0; sample < 12; ++sample) {
        const std::vector<double> point = draw_inside(dice, box);
        const Interval above = evaluate(form, point).value;
        ASSERT_GE(Rational(above.upper), shape.exact(exactly(point))) << shape.name;
      }
      for (const RealPoint& corner : corners(box)) {
        const std::vector<double> point{corner[0].get_d(), corner[1].get_d(), corner[2].get_d()};
        ASSERT_GE(Rational(evaluate(form, point).value.upper), shape.exact(corner)) << shape.name;
      }
    }
  }
}

// Oracle: the definition, h((a + b)/2) >= (h(a) + h(b))/2.
TEST(ConcaveAbove, IsConcave) {
  Dice dice(62);
  for (const Shape& shape : shapes()) {
    for (int trial = 0; trial < 300; ++trial) {
      const Box box = draw_shape_box(dice);
      const ConcaveForm form = concave_above(shape.expression, box);
      const std::vector<double> a = draw_inside(dice, box), b = draw_inside(dice, box);
      std::vector<double> middle;
      for (std::size_t i = 0; i < kShapeVariables; ++i) middle.push_back((a[i] + b[i]) / 2);
      const Interval at_a = evaluate(form, a).value, at_b = evaluate(form, b).value;
      ASSERT_GE(evaluate(form, middle).value.upper, (at_a.lower + at_b.lower) / 2) << shape.name;
    }
  }
}

// Oracle: central differences, h = 2^-13: exact for squares, h^2 times the third derivative for
// u^2/v, which is below 6 u^2/v^4 w^3 (u <= 30, v >= 1, w <= 2).
TEST(ConcaveAbove, SlopesAreThoseOfDifferences) {
  constexpr double kStep = 0x1p-13, kShare = 1e-3;
  Dice dice(63);
  for (const Shape& shape : shapes()) {
    for (int trial = 0; trial < 200; ++trial) {
      const Box box = draw_shape_box(dice);
      const ConcaveForm form = concave_above(shape.expression, box);
      const std::vector<double> point = draw_inside(dice, box);
      const ValueAndSlope at = evaluate(form, point);
      for (std::size_t i = 0; i < kShapeVariables; ++i) {
        std::vector<double> ahead = point, behind = point;
        ahead[i] += kStep;
        behind[i] -= kStep;
        const double difference =
            (evaluate(form, ahead).value.middle() - evaluate(form, behind).value.middle()) /
            (2 * kStep);
        ASSERT_NEAR(at.slope[i].middle(), difference, kShare * std::max(1.0, std::abs(difference)))
            << shape.name << " " << i;
        ASSERT_LT(at.slope[i].upper - at.slope[i].lower, 1e-9) << shape.name;
      }
    }
  }
}

// What has the right sign is kept as it is. Oracle: the formula itself.
TEST(ConcaveAbove, KeepsConcaveParts) {
  constexpr double kTouching = 1e-10;  // of values up to 1e4
  Dice dice(64);
  for (const std::size_t index : {0u, 1u, 3u}) {
    const Shape shape = shapes()[index];
    for (int trial = 0; trial < 100; ++trial) {
      const Box box = draw_shape_box(dice);
      const std::vector<double> point = draw_inside(dice, box);
      const Interval above = evaluate(concave_above(shape.expression, box), point).value;
      ASSERT_TRUE(encloses(above, shape.exact(exactly(point)))) << shape.name;
      ASSERT_LT(above.upper - above.lower, kTouching) << shape.name;
    }
  }
}

// Oracle: x^2 on [2, 6] lies below its chord 8 x - 12, which touches it at both ends.
TEST(ConcaveAbove, ChordOfASquareTouchesBothEnds) {
  const ConcaveForm form = concave_above(square(Expression::variable(0)), {{2, 6}});
  EXPECT_TRUE(form.squares.empty());
  EXPECT_NEAR(evaluate(form, std::vector{2.0}).value.upper, 4.0, 1e-12);
  EXPECT_NEAR(evaluate(form, std::vector{4.0}).value.upper, 20.0, 1e-12);
  EXPECT_NEAR(evaluate(form, std::vector{6.0}).value.upper, 36.0, 1e-12);
}

// Oracle: for x in 2..6, y in 1..2 the ratio x/y lies in 1..6: x^2/y <= 7 x - 6 y, with equality
// where the ratio is 1 or 6.
TEST(ConcaveAbove, ChordOfASquareOverTouchesTheCone) {
  const ConcaveForm form = concave_above(
      square_over(Expression::variable(0), Expression::variable(1)), {{2, 6}, {1, 2}});
  EXPECT_NEAR(evaluate(form, std::vector{2.0, 2.0}).value.upper, 2.0, 1e-12);
  EXPECT_NEAR(evaluate(form, std::vector{6.0, 1.0}).value.upper, 36.0, 1e-12);
  EXPECT_NEAR(evaluate(form, std::vector{3.0, 1.5}).value.upper, 12.0, 1e-12);
}

// The product 2..3 times 4..5 is at most 15.
TEST(ConcaveAbove, OtherPartsBecomeTheirGreatestValue) {
  const ConcaveForm form =
      concave_above(Expression::variable(0) * Expression::variable(1), {{2, 3}, {4, 5}});
  const ValueAndSlope at = evaluate(form, std::vector{2.0, 4.0});
  EXPECT_NEAR(at.value.upper, 15.0, 1e-12);
  EXPECT_EQ(at.slope[0].lower, 0.0);
  EXPECT_EQ(at.slope[1].upper, 0.0);
}

// Division by zero, a divisor that is not positive everywhere, a root of negative numbers.
TEST(ConcaveAbove, IsInfiniteWhereNothingIsKnown) {
  const Expression x = Expression::variable(0);
  for (const Expression& unknown :
       {1.0 / x, -(1.0 / x), square_over(x + 1.0, x), -square_over(x + 1.0, x), sqrt(x - 10.0)}) {
    const ConcaveForm form = concave_above(unknown + x, {{-2, 2}});
    EXPECT_EQ(evaluate(form, std::vector{1.0}).value.upper, HUGE_VAL);
  }
}

}  // namespace
}  // namespace torquewright::optimization
