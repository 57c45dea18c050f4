// SPDX-License-Identifier: Apache-2.0
// Intervals between doubles. Oracle: the same operations with 256 bits, which MPFI rounds outward.
#include "gearbox/proof/gears/rough_interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "gearbox/proof/claims/quantity.hpp"
#include "tests/gearbox/proof/naive_result.hpp"

namespace torquewright::gearbox::proof_test {
namespace {

using proof::Alternative;
using proof::Box;
using proof::Interval;
using proof::RoughInterval;

/// Whether the doubles hold all of it.
bool holds_all(const RoughInterval& rough, const Interval& precise) {
  const Interval least{Rational(rough.least())}, greatest{Rational(rough.greatest())};
  return !(least - precise.lower()).certainly_positive() &&
         !(greatest - precise.upper()).certainly_negative();
}

/// An operation on two numbers in both arithmetics.
template <typename Number>
Number applied(int operation, const Number& a, const Number& b) {
  switch (operation) {
    case 0:
      return a + b;
    case 1:
      return a - b;
    case 2:
      return a * b;
    case 3:
      return a / b;
    case 4:
      return sqrt(abs(a));
    case 5:
      return square(a - b);
    case 6:
      return max(a, b);
    case 7:
      return min(a, -b);
    case 8:
      return abs(a);
    default:
      return hull(a, b);
  }
}
constexpr int kOperations = 10;

// One operation on two fractions that no double holds: without a step outward the nearest double
// lies on one side of the result.
TEST(RoughInterval, HoldsWhatEveryOperationGives) {
  std::mt19937 random(5);
  const auto draw = [&] { return std::uniform_int_distribution<long>(-999, 999)(random); };
  const auto fraction = [&] {
    Rational value(draw(), std::abs(draw()) + 1);
    value.canonicalize();
    return value;
  };
  for (int trial = 0; trial < 20000; ++trial) {
    const Rational x = fraction(), y = fraction();
    const int operation = trial % kOperations;
    if (operation == 3 && y == 0) continue;
    const Interval precise = applied<Interval>(operation, x, y);
    const RoughInterval rough = applied<RoughInterval>(operation, x, y);
    ASSERT_TRUE(rough.is_defined());
    ASSERT_TRUE(holds_all(rough, precise)) << operation << " " << x << " " << y;
    const RoughInterval exact = precise;  // From 256 bits as narrow as doubles are.
    ASSERT_LE(exact.least(), exact.greatest());
    ASSERT_TRUE(holds_all(exact, precise));
  }
}

TEST(RoughInterval, KnowsNothingOutsideADomain) {
  const RoughInterval about_zero = hull(RoughInterval(-1), RoughInterval(1));
  for (const RoughInterval& nothing :
       {1 / about_zero, RoughInterval(1) / 0, sqrt(about_zero), 0 * (1 / about_zero) + 1}) {
    EXPECT_FALSE(nothing.is_defined());
    EXPECT_FALSE(nothing.certainly_positive() || nothing.certainly_negative());
    for (const RoughInterval& from : {abs(nothing), square(nothing), max(nothing, 1),
                                      min(nothing, 1), hull(nothing, 1), nothing * 0}) {
      EXPECT_FALSE(from.is_defined());
    }
  }
  EXPECT_FALSE(RoughInterval(0).certainly_positive());
  EXPECT_TRUE(RoughInterval(1).certainly_positive());
  EXPECT_EQ(square(about_zero).least(), 0.0);
}

// Objectives of boxes and of designs. Twice their hundred roundings apart at most: else more bits
// would be asked everywhere.
TEST(RoughInterval, HoldsWhatMoreBitsSayOfObjectives) {
  constexpr double kApart = 1e-12;
  Problem problem = buildable_inertia();
  problem.ratio_tolerance = Rational(1, 4);
  problem.friction_coefficient = Rational(1, 10);
  const Alternative alternative(problem, 3, Rational(3, 5));
  const Interval allowed(alternative.least_ratio, alternative.greatest_ratio);
  const RoughInterval roughly_allowed(alternative.least_ratio, alternative.greatest_ratio);
  std::mt19937 random(9);
  const auto draw = [&](long least, long most) {
    return std::uniform_int_distribution<long>(least, most)(random);
  };
  using proof::Measure;
  for (const Measure measure : {Measure::kPaperCost, Measure::kMass, Measure::kForwardEfficiency,
                                Measure::kBackwardEfficiency, Measure::kReflectedInertia}) {
    int told = 0;
    for (int trial = 0; trial < 2000; ++trial) {
      Box box{{draw(15, 90), draw(15, 90), 0}, {}};
      box.lower[2] = draw(1, box.lower[1] - 1);
      for (std::size_t i = 0; i < 3; ++i) {
        box.upper[i] = box.lower[i] + (trial % 2 == 0 ? 0 : draw(0, 8));
      }
      const Interval precise = proof::enclosure_on({measure}, alternative, box, allowed);
      const auto rough = proof::rough_enclosure_on({measure}, alternative, box, roughly_allowed);
      ASSERT_TRUE(rough);
      // A box that may hold zero below a fraction is left alone by both; designs never are.
      if (trial % 2 == 0) {
        ASSERT_TRUE(rough->is_defined());
      }
      if (!rough->is_defined()) continue;
      ++told;
      ASSERT_TRUE(holds_all(*rough, precise));
      const RoughInterval near = precise;
      // Efficiencies are what losses leave of 1.
      const bool is_share =
          measure == Measure::kForwardEfficiency || measure == Measure::kBackwardEfficiency;
      const double slack = kApart * std::max({std::abs(near.least()), std::abs(near.greatest()),
                                              is_share ? 1.0 : 0.0});
      ASSERT_GE(rough->least(), near.least() - slack);
      ASSERT_LE(rough->greatest(), near.greatest() + slack);
    }
    EXPECT_GT(told, 1500);
  }
}

}  // namespace
}  // namespace torquewright::gearbox::proof_test
