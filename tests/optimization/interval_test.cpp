// SPDX-License-Identifier: Apache-2.0
// Arithmetic of intervals. Oracle: the same operation on members, in exact fractions.
#include "optimization/expressions/interval.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "tests/optimization/random_intervals.hpp"

namespace torquewright::optimization {
namespace {

constexpr int kTrials = 1500;

struct Unary {
  std::string name;
  std::function<Interval(Interval)> enclose;
  std::function<Rational(const Rational&)> exact;
};
struct Binary {
  std::string name;
  std::function<Interval(Interval, Interval)> enclose;
  std::function<Rational(const Rational&, const Rational&)> exact;
};

const std::vector<Unary>& unary_operations() {
  static const std::vector<Unary> operations{
      {"negate", [](Interval a) { return -a; }, [](const Rational& a) -> Rational { return -a; }},
      {"square", [](Interval a) { return square(a); },
       [](const Rational& a) -> Rational { return a * a; }},
      {"abs", [](Interval a) { return abs(a); },
       [](const Rational& a) -> Rational { return ::abs(a); }},
  };
  return operations;
}

const std::vector<Binary>& binary_operations() {
  using R = Rational;
  static const std::vector<Binary> operations{
      {"sum", [](Interval a, Interval b) { return a + b; },
       [](const R& a, const R& b) -> R { return a + b; }},
      {"difference", [](Interval a, Interval b) { return a - b; },
       [](const R& a, const R& b) -> R { return a - b; }},
      {"product", [](Interval a, Interval b) { return a * b; },
       [](const R& a, const R& b) -> R { return a * b; }},
      {"min", [](Interval a, Interval b) { return min(a, b); },
       [](const R& a, const R& b) -> R { return std::min(a, b); }},
      {"max", [](Interval a, Interval b) { return max(a, b); },
       [](const R& a, const R& b) -> R { return std::max(a, b); }},
  };
  return operations;
}

class Magnitude : public testing::TestWithParam<std::int64_t> {};

TEST_P(Magnitude, OneArgumentIsEnclosed) {
  Dice dice(1);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Interval a = draw_interval(dice, GetParam());
    for (const Unary& operation : unary_operations()) {
      const Interval result = operation.enclose(a);
      for (const Rational& x : members(a)) {
        ASSERT_TRUE(encloses(result, operation.exact(x))) << operation.name << " " << x;
      }
    }
  }
}

TEST_P(Magnitude, TwoArgumentsAreEnclosed) {
  Dice dice(2);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Interval a = draw_interval(dice, GetParam()), b = draw_interval(dice, GetParam());
    for (const Binary& operation : binary_operations()) {
      const Interval result = operation.enclose(a, b);
      for (const Rational& x : members(a)) {
        for (const Rational& y : members(b)) {
          ASSERT_TRUE(encloses(result, operation.exact(x, y)))
              << operation.name << " " << x << " " << y;
        }
      }
    }
  }
}

TEST_P(Magnitude, QuotientsAreEnclosed) {
  Dice dice(3);
  int divided = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Interval a = draw_interval(dice, GetParam()), b = draw_interval(dice, GetParam());
    const Interval quotient = a / b, over = square_over(a, b);
    for (const Rational& x : members(a)) {
      for (const Rational& y : members(b)) {
        if (y == 0) continue;
        ASSERT_TRUE(encloses(quotient, Rational(x / y))) << x << " / " << y;
        ASSERT_TRUE(encloses(over, Rational(x * x / y))) << x << "^2 / " << y;
      }
    }
    divided += std::isfinite(quotient.upper) ? 1 : 0;
  }
  EXPECT_GT(divided, kTrials / 4);
}

// 2^40: numbers of everyday size. 2^1000: products overflow and underflow.
INSTANTIATE_TEST_SUITE_P(Interval, Magnitude, testing::Values(2, 40, 1000));

// Oracle: fractions. The true result lies between the largest double and infinity.
TEST(Interval, OverflowIsEnclosed) {
  const double most = std::numeric_limits<double>::max();
  EXPECT_TRUE(encloses(Interval(most) + Interval(most), Rational(most) * 2));
  EXPECT_TRUE(encloses(Interval(-most) - Interval(most), Rational(most) * -2));
  EXPECT_TRUE(encloses(Interval(most) * Interval(-3.0), Rational(most) * -3));
  EXPECT_TRUE(encloses(square(Interval(-most)), Rational(most) * Rational(most)));
  EXPECT_TRUE(encloses(Interval(most) / Interval(0.25), Rational(most) * 4));
  EXPECT_TRUE(encloses(square_over(Interval(most), 2.0), Rational(most) * Rational(most) / 2));
}

TEST(Interval, DividesToTheWholeLineAcrossZero) {
  for (const Interval& divisor :
       {Interval(-1, 1), Interval(0, 1), Interval(-1, 0), Interval(0, 0)}) {
    for (const Interval& dividend : {Interval(1, 2), Interval(0, 0), Interval(-3, 3)}) {
      const Interval quotient = dividend / divisor;
      EXPECT_EQ(quotient.lower, -kInfinity);
      EXPECT_EQ(quotient.upper, kInfinity);
    }
  }
}

TEST(Interval, SquareOverNeedsAPositiveDivisor) {
  for (const Interval& divisor : {Interval(-2, -1), Interval(0, 1), Interval(-1, 1)}) {
    EXPECT_EQ(square_over({1, 2}, divisor).lower, -kInfinity);
    EXPECT_EQ(square_over({1, 2}, divisor).upper, kInfinity);
  }
}

TEST(Interval, SquaresAndRootsAreNotNegative) {
  EXPECT_EQ(square(Interval(-2, 3)).lower, 0.0);
  EXPECT_EQ(square_over(Interval(-2, 3), Interval(1, 2)).lower, 0.0);
  EXPECT_GE(sqrt(Interval(0, 3)).lower, 0.0);
  EXPECT_EQ(abs(Interval(-2, 3)).lower, 0.0);
}

// Oracle: a few units in the last place: 2^-49 of the value; wider intervals would bound nothing.
TEST(Interval, IsTight) {
  constexpr double kWidth = 0x1p-49;
  Dice dice(4);
  for (int trial = 0; trial < kTrials; ++trial) {
    const double x = draw_number(dice, 40), y = draw_number(dice, 40);
    if (x == 0.0 || y == 0.0) continue;
    for (const Interval& result :
         {Interval(x) * Interval(y), Interval(x) / Interval(y), square(Interval(x)),
          sqrt(Interval(std::abs(x))), Interval(std::abs(x)) + Interval(std::abs(y)),
          square_over(Interval(x), std::abs(y))}) {
      ASSERT_LE(result.upper - result.lower, kWidth * 8 * std::abs(result.upper)) << x << " " << y;
    }
  }
}

TEST(Interval, CommonPartOrNowhere) {
  const Interval common = intersect({0, 2}, {1, 3});
  EXPECT_EQ(common.lower, 1.0);
  EXPECT_EQ(common.upper, 2.0);
  EXPECT_EQ(intersect({0, 1}, {1, 2}).upper, 1.0);
  EXPECT_TRUE(is_nowhere(intersect({0, 1}, {2, 3})));
}

TEST(Interval, ContainsItsEndsAndNoMore) {
  const Interval interval(-1, 2);
  EXPECT_TRUE(interval.contains(-1) && interval.contains(2) && interval.contains(0));
  EXPECT_FALSE(interval.contains(std::nextafter(2, 3)) || interval.contains(std::nan("")));
  EXPECT_EQ(interval.middle(), 0.5);
}

}  // namespace
}  // namespace torquewright::optimization
