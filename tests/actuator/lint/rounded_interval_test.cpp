// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/rounded_interval.hpp"

#include <gtest/gtest.h>

namespace torquewright::actuator::lint {
namespace {

// Oracle: the definition, half a unit of the last decimal of the shortest decimal.
TEST(HalfUnit, IsReadFromTheShortestDecimal) {
  EXPECT_DOUBLE_EQ(half_unit(0.32), 0.005);
  EXPECT_DOUBLE_EQ(half_unit(10), 0.5);
  EXPECT_DOUBLE_EQ(half_unit(320), 0.5);
  EXPECT_DOUBLE_EQ(half_unit(67.2), 0.05);
  EXPECT_DOUBLE_EQ(half_unit(0.000922), 5e-7);
  EXPECT_DOUBLE_EQ(half_unit(1e-7), 5e-8);
  EXPECT_DOUBLE_EQ(half_unit(1e6), 0.5);
  EXPECT_DOUBLE_EQ(half_unit(20.0), 0.5);  // the reader has dropped the zero
  EXPECT_EQ(half_unit(0.0), 0.0);
}

TEST(Derive, TakesTheExtremesOverAllCornersAndEachPointerOnce) {
  const RoundedInterval one = rounded(0.5, "/a");  // 0.45 to 0.55
  const RoundedInterval other = rounded(2, "/b");  // 1.5 to 2.5
  const RoundedInterval result = derive([](double x, double y, double z) { return x / y - z; }, one,
                                        other, rounded(0.1, "/a"));
  constexpr double kSomeRoundings = 1e-15;  // a few roundings of numbers below 1
  EXPECT_NEAR(result.value, 0.15, kSomeRoundings);
  EXPECT_NEAR(result.low, 0.45 / 2.5 - 0.15, kSomeRoundings);
  EXPECT_NEAR(result.high, 0.55 / 1.5 - 0.05, kSomeRoundings);
  EXPECT_EQ(result.pointers, (std::vector<std::string>{"/a", "/b"}));
}

TEST(Intervals, OverlapWhereTheyTouch) {
  const RoundedInterval ten = rounded(10, "");
  EXPECT_TRUE(overlap(ten, rounded(11, "")));
  EXPECT_TRUE(overlap(exact(10.5), ten));
  EXPECT_FALSE(overlap(exact(10.500001), ten));
  EXPECT_TRUE(lies_above(exact(10.500001), ten));
  EXPECT_FALSE(lies_above(ten, exact(10.500001)));
}

}  // namespace
}  // namespace torquewright::actuator::lint
