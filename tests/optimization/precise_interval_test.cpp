// SPDX-License-Identifier: Apache-2.0
// Intervals of 256 bits. Oracle: exact fractions; for functions MPFR at 400 bits.
#include "optimization/expressions/precise_interval.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "optimization/expressions/apply.hpp"
#include "tests/optimization/random_fraction.hpp"
#include "tests/optimization/random_intervals.hpp"

namespace torquewright::optimization {
namespace {

constexpr int kPreciseTrials = 500;

TEST(PreciseInterval, ArithmeticAgreesWithFractions) {
  Dice dice(31);
  for (int trial = 0; trial < kPreciseTrials; ++trial) {
    const Rational x = draw_fraction(dice, 100000, 100000), y = draw_fraction(dice, 100000, 100000);
    const PreciseInterval a(x), b(y);
    ASSERT_TRUE(agrees(-a, -x));
    ASSERT_TRUE(agrees(a + b, x + y));
    ASSERT_TRUE(agrees(a - b, x - y));
    ASSERT_TRUE(agrees(a * b, x * y));
    ASSERT_TRUE(agrees(square(a), x * x));
    ASSERT_TRUE(agrees(abs(a), ::abs(x)));
    ASSERT_TRUE(agrees(min(a, b), std::min(x, y)));
    ASSERT_TRUE(agrees(max(a, b), std::max(x, y)));
    if (y != 0) {
      ASSERT_TRUE(agrees(a / b, x / y));
    }
    if (y > 0) {
      ASSERT_TRUE(agrees(square_over(a, b), x * x / y));
    }
  }
}

TEST(PreciseInterval, FunctionsAgreeWithMpfr) {
  Dice dice(32);
  for (int trial = 0; trial < kPreciseTrials; ++trial) {
    Rational x = draw_fraction(dice, 100000, 100000);
    ASSERT_TRUE(agrees(atan(PreciseInterval(x)), true_atan(x)));
    if (x >= 0) {
      ASSERT_TRUE(agrees(sqrt(PreciseInterval(x)), true_sqrt(x)));
    }
    while (::abs(x) > 1) x /= 7;
    ASSERT_TRUE(agrees(sin(PreciseInterval(x)), true_sin(x)));
    ASSERT_TRUE(agrees(cos(PreciseInterval(x)), true_cos(x)));
    ASSERT_TRUE(agrees(tan(PreciseInterval(x)), true_tan(x)));
    ASSERT_TRUE(agrees(asin(PreciseInterval(x)), true_asin(x)));
    ASSERT_TRUE(agrees(acos(PreciseInterval(x)), true_acos(x)));
  }
  EXPECT_TRUE(agrees(PreciseInterval::pi(), true_pi()));
}

// Wide intervals: what holds for the members holds for the doubles around the result.
TEST(PreciseInterval, EnclosesWhatMembersGive) {
  Dice dice(33);
  for (int trial = 0; trial < kPreciseTrials; ++trial) {
    const Interval a = draw_interval(dice, 5), b = draw_interval(dice, 5);
    const PreciseInterval wide_a{PreciseInterval(a.lower), PreciseInterval(a.upper)};
    const PreciseInterval wide_b{PreciseInterval(b.lower), PreciseInterval(b.upper)};
    for (const Rational& x : members(a)) {
      ASSERT_TRUE(encloses(square(wide_a).outward(), x * x));
      ASSERT_TRUE(encloses(abs(wide_a).outward(), ::abs(x)));
      if (x >= 0) {
        ASSERT_TRUE(encloses(sqrt(wide_a).outward(), true_sqrt(x)));
      }
      if (::abs(x) <= 1) {
        ASSERT_TRUE(encloses(asin(wide_a).outward(), true_asin(x)));
      }
      if (::abs(x) <= 1) {
        ASSERT_TRUE(encloses(acos(wide_a).outward(), true_acos(x)));
      }
      for (const Rational& y : members(b)) {
        ASSERT_TRUE(encloses((wide_a * wide_b).outward(), x * y));
        ASSERT_TRUE(encloses((wide_a - wide_b).outward(), x - y));
        ASSERT_TRUE(encloses(min(wide_a, wide_b).outward(), std::min(x, y)));
        ASSERT_TRUE(encloses(max(wide_a, wide_b).outward(), std::max(x, y)));
        if (y != 0) {
          ASSERT_TRUE(encloses((wide_a / wide_b).outward(), Rational(x / y)));
        }
      }
    }
  }
}

// Rounding pushes 3 * (1/3) around 1: the part inside the domain counts.
TEST(PreciseInterval, ArgumentsAtTheEdgeOfADomainCount) {
  const PreciseInterval third = PreciseInterval(1.0) / PreciseInterval(3.0);
  const PreciseInterval one = third + third + third;
  EXPECT_TRUE(agrees(sqrt(one - PreciseInterval(1.0)) * sqrt(one - PreciseInterval(1.0)), 0));
  for (const PreciseInterval& edge : {one, -one}) {
    EXPECT_FALSE(asin(edge).is_nowhere());
    EXPECT_FALSE(acos(edge).is_nowhere());
  }
  // acos falls like the root of the distance: 2^-255 becomes 2^-127.
  EXPECT_TRUE(acos(one).outward().contains(0.0));
  EXPECT_LT(acos(one).outward().upper, 0x1p-120);
}

TEST(PreciseInterval, NowhereOutsideADomain) {
  const PreciseInterval outside = PreciseInterval(1.0) + PreciseInterval(0x1p-200);
  EXPECT_TRUE(asin(outside).is_nowhere());
  EXPECT_TRUE(acos(-outside).is_nowhere());
  EXPECT_TRUE(sqrt(PreciseInterval(-0x1p-200)).is_nowhere());
  EXPECT_FALSE(sqrt(PreciseInterval(0.0)).is_nowhere());
}

TEST(PreciseInterval, NowhereIsNeitherPositiveNorNegativeAndStays) {
  const PreciseInterval nowhere = sqrt(PreciseInterval(-1.0)), number(2.0);
  const auto expect_nowhere = [](const PreciseInterval& value, int operation) {
    EXPECT_TRUE(value.is_nowhere()) << operation;
    EXPECT_FALSE(value.is_positive() || value.is_negative()) << operation;
    EXPECT_TRUE(is_nowhere(value.outward())) << operation;
  };
  expect_nowhere(nowhere, -1);
  for (int i = static_cast<int>(Operation::kNegate); i <= static_cast<int>(Operation::kMaximum);
       ++i) {
    expect_nowhere(apply(static_cast<Operation>(i), nowhere, number), i);
  }
  for (const Operation operation :
       {Operation::kSum, Operation::kDifference, Operation::kProduct, Operation::kQuotient,
        Operation::kSquareOver, Operation::kMinimum, Operation::kMaximum}) {
    expect_nowhere(apply(operation, number, nowhere), static_cast<int>(operation));
  }
}

TEST(PreciseInterval, DivisionByZeroClaimsNothing) {
  for (const double dividend : {1.0, 0.0, -1.0}) {
    const PreciseInterval quotient = PreciseInterval(dividend) / PreciseInterval(0.0);
    EXPECT_FALSE(quotient.is_positive() || quotient.is_negative()) << dividend;
  }
}

TEST(PreciseInterval, SignsNeedEveryMember) {
  const PreciseInterval across(PreciseInterval(-1.0), PreciseInterval(1.0));
  const PreciseInterval from_zero(PreciseInterval(0.0), PreciseInterval(1.0));
  EXPECT_FALSE(across.is_positive() || across.is_negative());
  EXPECT_FALSE(from_zero.is_positive() || (-from_zero).is_negative());
  EXPECT_TRUE(PreciseInterval(0x1p-1074).is_positive());
  EXPECT_TRUE(PreciseInterval(-0x1p-1074).is_negative());
}

// Oracle: fractions, which no double hits.
TEST(PreciseInterval, OutwardGivesTheDoublesAround) {
  Dice dice(34);
  for (int trial = 0; trial < kPreciseTrials; ++trial) {
    const Rational x = draw_fraction(dice, 100000, 100000);
    const Interval around = PreciseInterval(x).outward();
    ASSERT_TRUE(encloses(around, x));
    ASSERT_LE(around.upper, std::nextafter(around.lower, HUGE_VAL));
    ASSERT_TRUE(around.contains(PreciseInterval(x).nearest()));
  }
  const Rational tiny = Rational(1) / (Rational(1) << 2000), huge = Rational(1) << 2000;
  EXPECT_TRUE(encloses(PreciseInterval(tiny).outward(), tiny));
  EXPECT_TRUE(encloses(PreciseInterval(huge).outward(), huge));
}

}  // namespace
}  // namespace torquewright::optimization
