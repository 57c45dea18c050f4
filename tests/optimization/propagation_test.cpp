// SPDX-License-Identifier: Apache-2.0
// Propagation keeps every feasible point that is good enough. Oracle: all points of small boxes.
#include "optimization/discrete/propagation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

/// What a cut says: no point beyond it satisfies its condition (or costs no more than the ceiling).
void expect_valid(const Cut& cut, const Toy& toy, const Judge& judge, double ceiling, Box& box) {
  Range& range = box[cut.variable];
  ASSERT_TRUE(range.contains(cut.value)) << "a cut leaves something, and takes something";
  ASSERT_NE(cut.value, cut.is_lower ? range.lower : range.upper);
  Box slab = box;
  (cut.is_lower ? slab[cut.variable].upper : slab[cut.variable].lower) =
      cut.is_lower ? cut.value - 1 : cut.value + 1;
  for (const Point& point : all_points(slab)) {
    if (cut.condition == kQuantity) {
      ASSERT_FALSE(toy.is_feasible(point) && judge.cost_around(point).lower <= ceiling);
    } else {
      ASSERT_FALSE(judge.holds(cut.condition, point));
    }
  }
  (cut.is_lower ? range.lower : range.upper) = cut.value;
}

void expect_keeps_all(const Toy& toy, double ceiling, int& cuts_made, int& refuted) {
  const Judge judge(toy.problem);
  Box box = toy.problem.domain;
  std::vector<Cut> cuts;
  const auto refuting = propagate(judge, ceiling, box, cuts);
  Box replayed = toy.problem.domain;
  for (const Cut& cut : cuts) {
    ASSERT_NO_FATAL_FAILURE(expect_valid(cut, toy, judge, ceiling, replayed));
  }
  EXPECT_EQ(replayed, box);
  for (const Point& point : brute_force(toy)) {
    if (judge.cost_around(point).lower > ceiling) continue;
    ASSERT_FALSE(refuting);
    ASSERT_TRUE(lies_in(point, box));
  }
  if (refuting && *refuting != kQuantity) {
    for (const Point& point : all_points(box)) ASSERT_FALSE(judge.holds(*refuting, point));
  }
  cuts_made += static_cast<int>(cuts.size());
  refuted += refuting ? 1 : 0;
}

TEST(Propagation, KeepsEveryFeasiblePoint) {
  Dice dice(91);
  int cuts = 0, refuted = 0;
  for (int trial = 0; trial < 500; ++trial) {
    ASSERT_NO_FATAL_FAILURE(expect_keeps_all(random_toy(dice, 10), HUGE_VAL, cuts, refuted));
  }
  EXPECT_GT(cuts, 200);
  EXPECT_GT(refuted, 30);
}

// The ceiling is what the middle one of the feasible points costs: those that cost as much stay.
TEST(Propagation, KeepsEveryPointUnderTheCeiling) {
  Dice dice(92);
  int cuts = 0, refuted = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Toy toy = random_toy(dice, 9);
    const std::vector<Point> feasible = brute_force(toy);
    if (feasible.empty()) continue;
    const Judge judge(toy.problem);
    const double ceiling = judge.ceiling(judge.cost_at(feasible[feasible.size() / 2]));
    ASSERT_NO_FATAL_FAILURE(expect_keeps_all(toy, ceiling, cuts, refuted));
  }
  EXPECT_GT(cuts, 100);
  EXPECT_EQ(refuted, 0);
}

// x = 7 exactly, from two linear conditions; the end where a condition is zero stays, strict or not
// (points decide), and what lies next to it goes.
TEST(Propagation, StopsWhereALinearConditionIsZero) {
  const Expression x = Expression::variable(0);
  for (const bool strict : {false, true}) {
    Problem problem{
        {"x"},
        {{0, 100}},
        {{"least", "c", "", 3.0 * x - 21.0, strict}, {"most", "c", "", 21.0 - 3.0 * x, strict}},
        {},
        {"goal", "", x, false, true}};
    Box box = problem.domain;
    std::vector<Cut> cuts;
    const auto refuting = propagate(Judge(problem), HUGE_VAL, box, cuts);
    ASSERT_EQ(cuts.size(), 2u);
    EXPECT_FALSE(cuts[0].is_lower != true || cuts[1].is_lower);
    EXPECT_TRUE(box[0].contains(7));
    EXPECT_LE(box[0].size(), 3);  // a rounding may leave the neighbours
    if (!strict) {
      EXPECT_FALSE(refuting);
    }
  }
}

// A body that is stated to grow is judged at one corner. x^2/y >= 20 with x <= 10, y in 1..50: y
// <= 5.
TEST(Propagation, IsSharpForMonotoneBodies) {
  const Expression x = Expression::variable(0), y = Expression::variable(1);
  Condition condition{"c", "c", "", square_over(x, y) - 20.0};
  condition.directions = {Direction::kGrows, Direction::kFalls};
  Problem problem{{"x", "y"}, {{1, 10}, {1, 50}}, {condition}, {}, {"goal", "", x, false, true}};
  Box box = problem.domain;
  std::vector<Cut> cuts;
  EXPECT_FALSE(propagate(Judge(problem), HUGE_VAL, box, cuts));
  EXPECT_EQ(box, (Box{{5, 10}, {1, 5}}));  // 5^2/1 = 25, 4^2/1 = 16
}

TEST(Propagation, NamesTheConditionThatRefutes) {
  const Expression x = Expression::variable(0);
  Problem problem{{"x"},
                  {{0, 9}},
                  {{"a", "a", "", x + 1.0}, {"b", "b", "", square(x) - 100.0}},
                  {},
                  {"goal", "", x, false, true}};
  Box box = problem.domain;
  std::vector<Cut> cuts;
  EXPECT_EQ(propagate(Judge(problem), HUGE_VAL, box, cuts), 1u);
  problem.conditions.pop_back();
  EXPECT_EQ(propagate(Judge(problem), -1.0, box, cuts), kQuantity);
  EXPECT_FALSE(propagate(Judge(problem), 0.0, box, cuts));
  EXPECT_EQ(box, (Box{{0, 0}}));
}

// Conditions that are judged at points never cut.
TEST(Propagation, LeavesConditionsAtPointsAlone) {
  Problem problem{{"x"},
                  {{0, 9}},
                  {{"a", "a", "", Expression::variable(0) - 100.0, false, false}},
                  {},
                  {"goal", "", Expression::variable(0), false, true}};
  Box box = problem.domain;
  std::vector<Cut> cuts;
  EXPECT_FALSE(propagate(Judge(problem), HUGE_VAL, box, cuts));
  EXPECT_TRUE(cuts.empty());
}

}  // namespace
}  // namespace torquewright::optimization
