// SPDX-License-Identifier: Apache-2.0
// What Ipopt is asked for is a dual point; what is believed is what that point proves.
#include <gtest/gtest.h>

#include <cmath>

#include "optimization/discrete/relaxation.hpp"
#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

Problem problem_of(const Expression& goal, const std::vector<Expression>& bodies, const Box& box) {
  Problem problem{{}, box, {}, {}, {"goal", "", goal, false, true}};
  problem.variables.resize(box.size(), "x");
  for (const Expression& body : bodies) problem.conditions.push_back({"c", "c", "", body});
  return problem;
}

DualBound solved(const Problem& problem, double ceiling = HUGE_VAL) {
  const Relaxation relaxation = relax_box(Judge(problem), problem.domain);
  return dual_bound(relaxation, solve(relaxation, ceiling));
}

// The solver stops at a gap of 1e-4 of the goal's variation on the box.
constexpr double kGapShare = 1e-4;

// Oracle: by hand: least x^2 + y^2 with x + y >= 4 is 8; it varies by 200 on the box.
TEST(Solve, FindsAKnownOptimum) {
  const DualBound bound =
      solved(problem_of(square(kX) + square(kY), {kX + kY - 4.0}, {{-10, 10}, {-10, 10}}));
  EXPECT_LE(bound.least_cost, 8.0);
  EXPECT_NEAR(bound.least_cost, 8.0, 2 * kGapShare * 200);
  EXPECT_FALSE(bound.is_infeasible);
}

// Oracle: by hand: a corner, least x + y with 2 x + y >= 7, x + 2 y >= 8 is 5 at (2, 3).
TEST(Solve, FindsAKnownCorner) {
  const DualBound bound =
      solved(problem_of(kX + kY, {2.0 * kX + kY - 7.0, kX + 2.0 * kY - 8.0}, {{0, 100}, {0, 100}}));
  EXPECT_LE(bound.least_cost, 5.0);
  EXPECT_NEAR(bound.least_cost, 5.0, 2 * kGapShare * 200);
}

// Oracle: by hand: least x^2/y with x + y >= 6, y <= 4 is 1 at (2, 4); on the box it varies by
// 1000.
TEST(Solve, FindsAKnownOptimumOfASquareOverALinearForm) {
  const DualBound bound =
      solved(problem_of(square_over(kX, kY), {kX + kY - 6.0, 4.0 - kY}, {{1, 30}, {1, 30}}));
  EXPECT_LE(bound.least_cost, 1.0);
  EXPECT_NEAR(bound.least_cost, 1.0, 2 * kGapShare * 1000);
}

// x + y >= 5 and x + 2 y <= 4 with x <= 3: empty, but by no condition alone.
TEST(Solve, ProvesABoxEmpty) {
  const Problem problem = problem_of(kX, {kX + kY - 5.0, 4.0 - kX - 2.0 * kY}, {{0, 3}, {0, 9}});
  const DualBound bound = solved(problem);
  EXPECT_TRUE(bound.is_infeasible || bound.least_cost > 3.0);
}

// x + y >= 5 and x + 2 y <= 5 leave the one point (5, 0): an interior-point method may well call
// this infeasible, and must not be believed.
TEST(Solve, NeverRefutesASinglePoint) {
  for (const double shift : {0.0, 1e-9, 1e-6}) {
    const DualBound bound = solved(
        problem_of(kX + kY, {kX + kY - (5.0 - shift), 5.0 - kX - 2.0 * kY}, {{0, 9}, {0, 9}}));
    EXPECT_FALSE(bound.is_infeasible);
    EXPECT_LE(bound.least_cost, 5.0);
  }
}

// One variable is fixed, or all are.
TEST(Solve, TakesBoxesWithoutInterior) {
  const Problem problem = problem_of(square(kX) + kY, {kX + kY - 4.0}, {{3, 3}, {0, 10}});
  EXPECT_LE(solved(problem).least_cost, 10.0);
  EXPECT_FALSE(solved(problem).is_infeasible);
  Problem point = problem;
  point.domain = {{3, 3}, {1, 1}};
  EXPECT_LE(solved(point).least_cost, 10.0);
  EXPECT_FALSE(solved(point).is_infeasible);
  point.domain = {{3, 3}, {2, 2}};
  EXPECT_LE(solved(point).least_cost, 11.0);
}

TEST(Solve, TakesAProblemWithoutConditions) {
  const DualBound bound = solved(problem_of(square(kX) - 2.0 * kX, {}, {{-7, 9}}));
  EXPECT_LE(bound.least_cost, -1.0);
  EXPECT_NEAR(bound.least_cost, -1.0, 2 * kGapShare * 100);
}

// A gain without a bound makes every solve fail at its first number; huge and tiny numbers make it
// run to its limit of iterations. There is a true bound, or none.
TEST(Solve, AFailedSolveClaimsNothing) {
  const DualBound unbounded = solved(problem_of(1.0 / kX, {kX - 1.0}, {{-3, 3}}));
  EXPECT_EQ(unbounded.least_cost, -HUGE_VAL);
  EXPECT_FALSE(unbounded.is_infeasible);
  const double far = 0x1p40;
  for (const double steepness : {1e-12, 1.0, 1e12}) {
    const DualBound bound =
        solved(problem_of(steepness * square_over(kX, kY), {kX - far, 1e-9 * (kX - 2.0 * kY)},
                          {{1, std::int64_t{1} << 45}, {1, std::int64_t{1} << 45}}));
    // Feasible: x = 2^40, y = 2^39, which costs 2^41 steepness.
    EXPECT_FALSE(bound.is_infeasible);
    EXPECT_LE(bound.least_cost, steepness * 0x1p41);
  }
}

// Ipopt's dual point, its status unseen, on random boxes. Oracle: all points.
TEST(Solve, IsTrueOnRandomProblems) {
  Dice dice(81);
  int refuted = 0, bounded = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const Toy toy = random_toy(dice, 8);
    const Judge judge(toy.problem);
    const std::vector<Point> feasible = brute_force(toy);
    const DualBound bound = solved(toy.problem);
    refuted += bound.is_infeasible ? 1 : 0;
    if (feasible.empty()) continue;
    ASSERT_FALSE(bound.is_infeasible);
    if (std::isinf(bound.least_cost)) continue;
    const PreciseInterval least = judge.cost_at(feasible.front());
    ASSERT_FALSE((least - PreciseInterval(bound.least_cost)).is_negative());
    bounded += bound.least_cost > judge.cost_over(toy.problem.domain).lower ? 1 : 0;
  }
  EXPECT_GT(refuted, 5);
  EXPECT_GT(bounded, 5);
}

// A dual point holds for parts of its box as well, and parts may relax more conditions: here the
// second one says nothing where x may be zero.
TEST(Solve, GivesAMultiplierForEveryConditionOfTheProblem) {
  const Judge judge(
      problem_of(kX, {kX + kY - 4.0, 20.0 - square_over(kY, kX)}, {{0, 10}, {0, 10}}));
  const Relaxation whole = relax_box(judge, {{0, 10}, {0, 10}});
  const Relaxation part = relax_box(judge, {{1, 10}, {0, 10}});
  ASSERT_EQ(whole.conditions.size(), 1u);
  ASSERT_EQ(part.conditions.size(), 2u);
  const DualPoint dual = solve(whole, HUGE_VAL);
  ASSERT_EQ(dual.multipliers.size(), judge.condition_count());
  EXPECT_LE(dual_bound(part, dual).least_cost, 1.0);
}

// It stops early at a ceiling, but what it found is still true.
TEST(Solve, StopsAtACeiling) {
  const Problem problem =
      problem_of(square(kX) + square(kY), {kX + kY - 4.0}, {{-10, 10}, {-10, 10}});
  const DualBound bound = solved(problem, 2.0);
  EXPECT_GT(bound.least_cost, 2.0);
  EXPECT_LE(bound.least_cost, 8.0);
}

}  // namespace
}  // namespace torquewright::optimization
