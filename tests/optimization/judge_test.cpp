// SPDX-License-Identifier: Apache-2.0
// What a judge says of points and boxes. Oracle: exact fractions, all points of small boxes.
#include "optimization/discrete/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

Problem problem_of(const Expression& body, bool strict) {
  return {{"x", "y"},
          {{-9, 9}, {-9, 9}},
          {{"c", "c", "", body, strict}},
          {},
          {"goal", "", kX, false, true}};
}

TEST(Judge, FeasiblePointsAreThoseOfFractions) {
  Dice dice(111);
  int feasible = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Toy toy = random_toy(dice, 7);
    const Judge judge(toy.problem);
    for (const Point& point : all_points(toy.problem.domain)) {
      ASSERT_EQ(judge.is_feasible(point), toy.is_feasible(point));
      feasible += toy.is_feasible(point) ? 1 : 0;
      const Rational cost = toy.cost(point);
      const Rational value = judge.has_exact_cost() ? cost : sgn(cost) * true_sqrt(::abs(cost));
      ASSERT_TRUE(agrees(judge.cost_at(point), value));
      ASSERT_LE(Rational(judge.cost_around(point).lower), value);
    }
  }
  EXPECT_GT(feasible, 1000);
}

TEST(Judge, BoxesAreRefutedOnlyIfNoPointHolds) {
  Dice dice(112);
  int refuted = 0;
  for (int trial = 0; trial < 250; ++trial) {
    const Toy toy = random_toy(dice, 7);
    const Judge judge(toy.problem);
    const Interval costs = judge.cost_over(toy.problem.domain);
    for (const Point& point : all_points(toy.problem.domain)) {
      ASSERT_FALSE((judge.cost_at(point) - PreciseInterval(costs.lower)).is_negative());
      ASSERT_FALSE((judge.cost_at(point) - PreciseInterval(costs.upper)).is_positive());
    }
    for (std::size_t i = 0; i < judge.condition_count(); ++i) {
      if (!judge.refutes(i, toy.problem.domain)) continue;
      ++refuted;
      for (const Point& point : all_points(toy.problem.domain)) {
        ASSERT_FALSE(judge.holds(i, point));
      }
    }
  }
  EXPECT_GT(refuted, 20);
}

// x/3 + y/7 is a sum of rounded doubles; 1/3 + 2/7 is 13/21. Equality holds, strict inequality does
// not.
TEST(Judge, DecidesEqualityExactly) {
  const Expression body = kX / 3.0 + kY / 7.0 - Expression(Rational(13, 21));
  for (const Expression& either : {body, -body}) {
    EXPECT_TRUE(Judge(problem_of(either, false)).holds(0, Point{1, 2}));
    EXPECT_FALSE(Judge(problem_of(either, true)).holds(0, Point{1, 2}));
  }
  const Rational little = Rational(1) / (Rational(1) << 180);
  EXPECT_FALSE(Judge(problem_of(body - Expression(little), false)).holds(0, Point{1, 2}));
  EXPECT_TRUE(Judge(problem_of(body + Expression(little), true)).holds(0, Point{1, 2}));
}

// sin(pi/6) = 1/2: a number with infinitely many digits on both sides of the comparison.
TEST(Judge, DecidesEqualityOfAngles) {
  const Expression body = sin(Expression::pi() / 6.0) * kX - kY;
  EXPECT_TRUE(Judge(problem_of(body, false)).holds(0, Point{4, 2}));
  EXPECT_FALSE(Judge(problem_of(body, true)).holds(0, Point{4, 2}));
}

TEST(Judge, ConditionsDoNotHoldWhereTheyHaveNoValue) {
  for (const Expression& body : {sqrt(kX) + 1.0, 2.0 - acos(kX + 2.0)}) {
    EXPECT_FALSE(Judge(problem_of(body, false)).holds(0, Point{-4, 0}));
    EXPECT_FALSE(Judge(problem_of(body, false)).is_feasible(Point{-4, 0}));
  }
}

// A strict condition refutes a box where its greatest value is zero; the other kind does not.
TEST(Judge, RefutesByKind) {
  const Judge loose(problem_of(-square(kX), false)), strict(problem_of(-square(kX), true));
  EXPECT_FALSE(loose.refutes(0, {{0, 0}, {0, 0}}));
  EXPECT_TRUE(strict.refutes(0, {{0, 0}, {0, 0}}));
  EXPECT_TRUE(loose.refutes(0, {{1, 2}, {0, 0}}));
  EXPECT_FALSE(strict.holds(0, Point{0, 0}));
  EXPECT_TRUE(loose.holds(0, Point{0, 0}));
}

TEST(Judge, UsesDirections) {
  // On a box, x - x^2/100 spans -15..21 by intervals; growing, it ends at 24 - 5.76 = 18.24.
  Problem problem = problem_of(kX - square(kX) / 100.0 - 19.0, false);
  const Box box{{4, 24}, {0, 0}};
  EXPECT_FALSE(Judge(problem).refutes(0, box));
  problem.conditions[0].directions = {Direction::kGrows, Direction::kUnknown};
  EXPECT_TRUE(Judge(problem).refutes(0, box));
  problem.conditions[0].body = problem.conditions[0].body + 0.8;
  EXPECT_FALSE(Judge(problem).refutes(0, box));
  problem.conditions[0].body = -(kX - square(kX) / 100.0) + 3.8;  // at 4: 4 - 0.16 = 3.84
  problem.conditions[0].directions = {Direction::kFalls, Direction::kUnknown};
  EXPECT_TRUE(Judge(problem).refutes(0, box));
  problem.conditions[0].body = problem.conditions[0].body + 0.08;
  EXPECT_FALSE(Judge(problem).refutes(0, box));
}

TEST(Judge, ComparesExactlyOrWithATieOfAMillionthMillionth) {
  Problem problem = problem_of(kX, false);
  const auto one_and = [](const Rational& more) { return PreciseInterval(Rational(1 + more)); };
  const Rational tiny = Rational(1) / (Rational(1) << 180);
  const Judge exact(problem);
  EXPECT_EQ(exact.compare(one_and(0), one_and(0)), 0);
  EXPECT_EQ(exact.compare(one_and(0), one_and(tiny)), -1);
  EXPECT_EQ(exact.compare(one_and(tiny), one_and(0)), 1);
  problem.goal.exact = false;
  const Judge rounded(problem);
  const Rational tie(1, 1'000'000'000'000);
  EXPECT_EQ(rounded.compare(one_and(0), one_and(tie * 99 / 100)), 0);
  EXPECT_EQ(rounded.compare(one_and(0), one_and(tie * 101 / 100)), -1);
  EXPECT_EQ(rounded.compare(one_and(tie * 101 / 100), one_and(0)), 1);
}

// Whatever compares as equal lies under the ceiling.
TEST(Judge, CeilingAdmitsTies) {
  Problem problem = problem_of(kX, false);
  problem.goal.exact = false;
  Dice dice(113);
  for (const bool is_exact : {false, true}) {
    problem.goal.exact = is_exact;
    const Judge judge(problem);
    for (int trial = 0; trial < 500; ++trial) {
      Rational value(dice.between(-1000, 1000), dice.between(1, 1000));
      value.canonicalize();
      const Rational share(dice.between(-1000, 1000), 1000 * 1'000'000'000'000);
      const PreciseInterval cost(value), other(Rational(value + value * share));
      ASSERT_GE(Rational(judge.ceiling(cost)), value);
      if (judge.compare(other, cost) <= 0) {
        ASSERT_LE(other.outward().lower, judge.ceiling(cost));
      }
    }
  }
}

// Where a maximised goal has an enclosure, the narrower of both counts; disjoint: the value's own.
TEST(Judge, CostUsesTheEnclosure) {
  Problem problem = problem_of(kX, false);
  problem.goal.maximise = true;
  problem.goal.enclosure = Expression::between(2, 3);
  EXPECT_NEAR(Judge(problem).cost_over({{0, 9}, {0, 0}}).lower, -3.0, 1e-12);
  EXPECT_NEAR(Judge(problem).cost_over({{5, 9}, {0, 0}}).lower, -9.0, 1e-12);
}

TEST(Judge, CostsNothingKnownWhereTheGoalHasNoValue) {
  Problem problem = problem_of(kX, false);
  problem.goal.value = sqrt(kX - 100.0);
  EXPECT_EQ(Judge(problem).cost_over({{0, 9}, {0, 0}}).lower, -HUGE_VAL);
  EXPECT_EQ(Judge(problem).cost_around(Point{0, 0}).lower, -HUGE_VAL);
}

TEST(Judge, NeedsOneRangeForEachVariable) {
  Problem problem = problem_of(kX, false);
  problem.domain.pop_back();
  EXPECT_THROW(Judge{problem}, std::logic_error);
}

}  // namespace
}  // namespace torquewright::optimization
