// SPDX-License-Identifier: Apache-2.0
// Affine forms. Oracle: exact fractions; a linear function is extreme at the corners of a box, and
// these are enumerated.
#include "optimization/expressions/affine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/optimization/boxes.hpp"
#include "tests/optimization/random_fraction.hpp"

namespace torquewright::optimization {
namespace {

constexpr std::size_t kVariables = 3;
constexpr double kRounding = 1e-11;  // eight roundings of numbers up to 5000

struct Linear {
  Rational constant;
  std::vector<Rational> coefficients;

  Rational at(const RealPoint& point) const {
    Rational value = constant;
    for (std::size_t i = 0; i < kVariables; ++i) value += coefficients[i] * point[i];
    return value;
  }
};

Linear draw_linear(Dice& dice) {
  Linear linear{draw_fraction(dice, 50, 30), {}};
  for (std::size_t i = 0; i < kVariables; ++i)
    linear.coefficients.push_back(draw_fraction(dice, 50, 30));
  return linear;
}

Affine enclose(const Linear& linear) {
  const auto around = [](const Rational& value) { return PreciseInterval(value).outward(); };
  Affine form{around(linear.constant), {}};
  for (const Rational& value : linear.coefficients) form.coefficients.push_back(around(value));
  return form;
}

void expect_forms(const Affine& form, const Linear& linear) {
  EXPECT_TRUE(encloses(form.constant, linear.constant));
  ASSERT_EQ(form.coefficients.size(), kVariables);
  for (std::size_t i = 0; i < kVariables; ++i) {
    EXPECT_TRUE(encloses(form.coefficients[i], linear.coefficients[i])) << i;
    EXPECT_LT(form.coefficients[i].upper - form.coefficients[i].lower, kRounding) << i;
  }
}

TEST(Affine, BoundsAreThoseOfTheCorners) {
  Dice dice(51);
  for (int trial = 0; trial < 500; ++trial) {
    const Linear linear = draw_linear(dice);
    const Box box = draw_box(dice, kVariables, -30, 30, 20);
    const Interval range = enclose(linear).over(box);
    Rational least = linear.at(corners(box).front()), greatest = least;
    for (const RealPoint& corner : corners(box)) {
      least = std::min(least, linear.at(corner));
      greatest = std::max(greatest, linear.at(corner));
    }
    ASSERT_TRUE(encloses(range, least) && encloses(range, greatest));
    ASSERT_NEAR(range.lower, least.get_d(), kRounding);
    ASSERT_NEAR(range.upper, greatest.get_d(), kRounding);
    const std::vector<double> point = draw_inside(dice, box);
    ASSERT_TRUE(encloses(enclose(linear).at(point), linear.at(exactly(point))));
  }
}

TEST(Affine, SumsAndMultiplesAreEnclosed) {
  Dice dice(52);
  for (int trial = 0; trial < 300; ++trial) {
    const Linear a = draw_linear(dice), b = draw_linear(dice);
    const Rational factor = draw_fraction(dice, 50, 30);
    Linear total{a.constant + factor * b.constant, {}};
    for (std::size_t i = 0; i < kVariables; ++i) {
      total.coefficients.push_back(a.coefficients[i] + factor * b.coefficients[i]);
    }
    expect_forms(sum(enclose(a), scaled(enclose(b), PreciseInterval(factor).outward())), total);
  }
}

// 2 (x - y/3) - (-(z + 5))/7 + 4 = 2 x - 2/3 y + 1/7 z + 33/7
TEST(AffineForm, ReadsWhateverIsBuiltAsOne) {
  const Expression x = Expression::variable(0), y = Expression::variable(1),
                   z = Expression::variable(2);
  const auto form = affine_form(2.0 * (x - y / 3.0) - (-(z + 5.0)) / 7.0 + 4.0, kVariables);
  ASSERT_TRUE(form);
  expect_forms(*form, {Rational(33, 7), {2, Rational(-2, 3), Rational(1, 7)}});
  const auto constant = affine_form(Expression(Rational(1, 3)), kVariables);
  ASSERT_TRUE(constant);
  expect_forms(*constant, {Rational(1, 3), {0, 0, 0}});
}

TEST(AffineForm, AddsUpWhatAVariableContributes) {
  const Expression x = Expression::variable(0), y = Expression::variable(1);
  const auto form = affine_form((x + y) * 3.0 - x - (y - x), kVariables);
  ASSERT_TRUE(form);
  expect_forms(*form, {0, {3, 2, 0}});
}

TEST(AffineForm, RefusesWhatIsNot) {
  const Expression x = Expression::variable(0), y = Expression::variable(1);
  for (const Expression& curved :
       {x * y, 1.0 / x, square(x), square_over(x, y + 9.0), sqrt(x), abs(x), min(x, y), max(x, y),
        atan(x), asin(x), acos(x), x + x * y, -(x / y), 2.0 * square(x)}) {
    EXPECT_FALSE(affine_form(curved, kVariables));
  }
}

// Nothing is known of a constant divided by zero, and nothing may be claimed.
TEST(AffineForm, DivisionByZeroClaimsNothing) {
  const auto form = affine_form(Expression::variable(0) / Expression(0.0), kVariables);
  ASSERT_TRUE(form);
  const Interval range = form->over({{1, 2}, {0, 0}, {0, 0}});
  EXPECT_FALSE(range.lower > -HUGE_VAL || range.upper < HUGE_VAL);
}

}  // namespace
}  // namespace torquewright::optimization
