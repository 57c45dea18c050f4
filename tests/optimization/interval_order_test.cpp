// SPDX-License-Identifier: Apache-2.0
// What holds of every operation: a part of the argument gives a part of the result, and no
// operation makes an interval that is half a number.
#include <gtest/gtest.h>

#include <limits>

#include "optimization/expressions/apply.hpp"
#include "tests/optimization/random_intervals.hpp"

namespace torquewright::optimization {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();
constexpr Operation kOperations[] = {
    Operation::kNegate,   Operation::kSum,       Operation::kDifference, Operation::kProduct,
    Operation::kQuotient, Operation::kSquare,    Operation::kSquareOver, Operation::kSquareRoot,
    Operation::kArcSine,  Operation::kArcCosine, Operation::kArcTangent, Operation::kAbsolute,
    Operation::kMinimum,  Operation::kMaximum};

Interval part_of(Dice& dice, const Interval& whole) {
  const double width = whole.upper - whole.lower;
  const Interval share = draw_between(dice, 0.0, 1.0);
  const auto inside = [&](double value) { return std::clamp(value, whole.lower, whole.upper); };
  return {inside(whole.lower + share.lower * width), inside(whole.lower + share.upper * width)};
}

// Oracle: inclusion: x in a in b implies f(x) in f(a) in f(b). The libraries' angles may differ by
// a unit in the last place between neighbours.
TEST(IntervalOrder, APartGivesAPart) {
  constexpr double kUnits = 0x1p-50;
  Dice dice(21);
  for (int trial = 0; trial < 4000; ++trial) {
    const std::int64_t exponent = trial % 2 == 0 ? 1 : 60;
    const Interval a = draw_interval(dice, exponent), b = draw_interval(dice, exponent);
    const Interval a_part = part_of(dice, a), b_part = part_of(dice, b);
    for (const Operation operation : kOperations) {
      const Interval whole = apply(operation, a, b), part = apply(operation, a_part, b_part);
      if (is_nowhere(part)) continue;
      const bool is_angle = operation == Operation::kArcSine ||
                            operation == Operation::kArcCosine ||
                            operation == Operation::kArcTangent;
      const double slack = is_angle ? kUnits * 4 : 0.0;
      ASSERT_LE(whole.lower, part.lower + slack) << static_cast<int>(operation);
      ASSERT_GE(whole.upper, part.upper - slack) << static_cast<int>(operation);
    }
  }
}

// Every combination of extreme ends. Both ends are numbers in the right order, or both are NaN.
TEST(IntervalOrder, NoOperationYieldsHalfANumber) {
  const std::vector<double> ends{-kInfinity, -kMost, -1.0,  -0x1p-1074, 0.0,
                                 0x1p-1074,  1.0,    kMost, kInfinity};
  std::vector<Interval> intervals{{std::nan(""), std::nan("")}};
  for (const double lower : ends) {
    for (const double upper : ends) {
      if (lower <= upper && lower < kInfinity && upper > -kInfinity) {
        intervals.push_back({lower, upper});
      }
    }
  }
  for (const Interval& a : intervals) {
    for (const Interval& b : intervals) {
      for (const Operation operation : kOperations) {
        const Interval result = apply(operation, a, b);
        const bool is_nowhere = std::isnan(result.lower) && std::isnan(result.upper);
        ASSERT_TRUE(is_nowhere || result.lower <= result.upper)
            << static_cast<int>(operation) << " [" << a.lower << ", " << a.upper << "] [" << b.lower
            << ", " << b.upper << "]";
      }
    }
  }
}

TEST(IntervalOrder, NowhereStaysNowhere) {
  const Interval nowhere(std::nan(""), std::nan("")), number(1.0, 2.0);
  for (const Operation operation : kOperations) {
    EXPECT_TRUE(is_nowhere(apply(operation, nowhere, nowhere))) << static_cast<int>(operation);
  }
  for (const Operation operation :
       {Operation::kSum, Operation::kDifference, Operation::kProduct, Operation::kQuotient,
        Operation::kSquareOver, Operation::kMinimum, Operation::kMaximum}) {
    EXPECT_TRUE(is_nowhere(apply(operation, nowhere, number))) << static_cast<int>(operation);
    EXPECT_TRUE(is_nowhere(apply(operation, number, nowhere))) << static_cast<int>(operation);
  }
  EXPECT_TRUE(is_nowhere(intersect(nowhere, number)));
  EXPECT_TRUE(is_nowhere(intersect(number, nowhere)));
}

}  // namespace
}  // namespace torquewright::optimization
