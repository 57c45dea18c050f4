// SPDX-License-Identifier: Apache-2.0
// Dual bounds. Any point and any multipliers must give a true bound. Oracle: all points of the box,
// in exact fractions.
#include "optimization/discrete/relaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/optimization/boxes.hpp"
#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// What is true of a box: a relaxation knows nothing of predicates and of conditions at points.
struct Truth {
  bool is_empty = true;
  Rational least_cost;
};

Truth truth_of(const Toy& toy, const Judge& judge, const Box& box) {
  Truth truth;
  for (const Point& point : all_points(box)) {
    if (!toy.is_feasible(point)) continue;
    const Rational cost = toy.cost(point);
    if (truth.is_empty || cost < truth.least_cost) truth.least_cost = cost;
    truth.is_empty = false;
  }
  if (!judge.has_exact_cost() && !truth.is_empty) {  // the toy gives what is under the root
    truth.least_cost = sgn(truth.least_cost) * true_sqrt(::abs(truth.least_cost));
  }
  return truth;
}

void expect_true(const DualBound& bound, const Truth& truth) {
  ASSERT_FALSE(std::isnan(bound.least_cost));
  if (truth.is_empty) return;  // anything is true of nothing
  ASSERT_FALSE(bound.is_infeasible);
  ASSERT_TRUE(bound.least_cost == -kInfinity ||
              (std::isfinite(bound.least_cost) && Rational(bound.least_cost) <= truth.least_cost))
      << bound.least_cost << " > " << truth.least_cost.get_d();
}

DualPoint draw_dual(Dice& dice, const Box& box, std::size_t conditions) {
  DualPoint dual{draw_inside(dice, box), {}};
  for (std::size_t i = 0; i < conditions; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(dice.between(-12, 12)));
    const double odd =
        dice.one_of(std::vector<double>{0.0, -1.0, kNaN, kInfinity, -kInfinity, 1e300});
    dual.multipliers.push_back(
        dice.chance(15) ? odd : static_cast<double>(dice.between(0, 8)) * size / 8);
  }
  return dual;
}

TEST(DualBound, IsTrueForAnyMultipliers) {
  Dice dice(71);
  int useful = 0, infeasible = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Toy toy = random_toy(dice, 12);
    const Judge judge(toy.problem);
    Box box = toy.problem.domain;
    for (Range& range : box) range.upper = range.lower + dice.between(0, range.size() - 1);
    const Relaxation relaxation = relax_box(judge, box);
    const Truth truth = truth_of(toy, judge, box);
    for (int sample = 0; sample < 40; ++sample) {
      const DualBound bound = dual_bound(relaxation, draw_dual(dice, box, judge.condition_count()));
      expect_true(bound, truth);
      useful += bound.least_cost > judge.cost_over(box).lower ? 1 : 0;
      infeasible += bound.is_infeasible ? 1 : 0;
    }
  }
  EXPECT_GT(useful, 100);
  EXPECT_GT(infeasible, 100);
}

TEST(DualBound, IsTrueAtPointsOutsideTheBox) {
  Dice dice(72);
  for (int trial = 0; trial < 200; ++trial) {
    const Toy toy = random_toy(dice, 8);
    const Judge judge(toy.problem);
    const Box& box = toy.problem.domain;
    DualPoint dual = draw_dual(dice, box, judge.condition_count());
    dual.point[0] = dice.one_of(std::vector<double>{-1e300, 1e300, -kInfinity, kInfinity, kNaN});
    expect_true(dual_bound(relax_box(judge, box), dual), truth_of(toy, judge, box));
  }
}

Judge judge_of(const Expression& goal, const std::vector<Expression>& bodies, const Box& box,
               bool maximise = false) {
  Problem problem{{}, box, {}, {}, {"goal", "", goal, maximise, true}};
  problem.variables.resize(box.size(), "x");
  for (const Expression& body : bodies) problem.conditions.push_back({"c", "c", "", body});
  return Judge(problem);
}

// Oracle: by hand. min x^2 + y^2, x + y >= 4: the optimum 8 at (2, 2), multiplier 4.
TEST(DualBound, IsTightAtTheDualOptimum) {
  const Judge judge = judge_of(square(kX) + square(kY), {kX + kY - 4.0}, {{-10, 10}, {-10, 10}});
  const Relaxation relaxation = relax_box(judge, {{-10, 10}, {-10, 10}});
  const DualBound best = dual_bound(relaxation, {{2.0, 2.0}, {4.0}});
  EXPECT_NEAR(best.least_cost, 8.0, 1e-12);
  EXPECT_LE(best.least_cost, 8.0);
  EXPECT_FALSE(best.is_infeasible);
  // Lagrange: least of x^2 + y^2 + 3 (4 - x - y) is 7.5, at (1.5, 1.5).
  EXPECT_NEAR(dual_bound(relaxation, {{1.5, 1.5}, {3.0}}).least_cost, 7.5, 1e-12);
}

// Oracle: by hand. max 12 x - x^2/y, y <= 2, x <= 20 - y: 72 at (12, 2), multiplier 36 of y <= 2.
TEST(DualBound, IsTightForASquareOverALinearForm) {
  const Box box{{1, 30}, {1, 30}};
  const Judge judge =
      judge_of(12.0 * kX - square_over(kX, kY), {2.0 - kY, 20.0 - kX - kY}, box, true);
  const DualBound best = dual_bound(relax_box(judge, box), {{12.0, 2.0}, {36.0, 0.0}});
  EXPECT_NEAR(best.least_cost, -72.0, 1e-10);
  EXPECT_LE(best.least_cost, -72.0);
}

// Oracle: by hand. x + y >= 5 and x + 2 y <= 4 with y >= 0 and x <= 3 contradict each other:
// twice the first and once the second leave x >= 6.
TEST(DualBound, RefutesByASum) {
  const Box box{{0, 3}, {0, 9}};
  const Judge judge = judge_of(kX, {kX + kY - 5.0, 4.0 - kX - 2.0 * kY}, box);
  const Relaxation relaxation = relax_box(judge, box);
  EXPECT_TRUE(dual_bound(relaxation, {{1.0, 1.0}, {2.0, 1.0}}).is_infeasible);
  EXPECT_FALSE(dual_bound(relaxation, {{1.0, 1.0}, {1.0, 0.0}}).is_infeasible);
  // A sum that reaches zero, at x = 6, proves nothing.
  const Box wider{{0, 6}, {0, 9}};
  EXPECT_FALSE(dual_bound(relax_box(judge, wider), {{1.0, 1.0}, {2.0, 1.0}}).is_infeasible);
}

// Negative and non-finite multipliers count as zero.
TEST(DualBound, IgnoresMultipliersThatAreNone) {
  const Box box{{-10, 10}, {-10, 10}};
  const Judge judge = judge_of(square(kX) + square(kY), {kX + kY - 4.0}, box);
  const Relaxation relaxation = relax_box(judge, box);
  const double without = dual_bound(relaxation, {{2.0, 2.0}, {0.0}}).least_cost;
  for (const double none : {-4.0, kNaN, kInfinity, -kInfinity}) {
    EXPECT_EQ(dual_bound(relaxation, {{2.0, 2.0}, {none}}).least_cost, without);
  }
}

// A goal of no known shape is bounded by its enclosure: on feasible points 1/x <= 1/2 here.
TEST(Relaxation, UsesTheGoalsEnclosure) {
  const Box box{{1, 10}};
  Problem problem{{"x"}, box, {{"c", "c", "", kX - 2.0}}, {}, {"goal", "", 1.0 / kX, true, false}};
  EXPECT_NEAR(dual_bound(relax_box(Judge(problem), box), {{2.0}, {0.0}}).least_cost, -1.0, 1e-12);
  problem.goal.enclosure = Expression::between(Rational(1, 10), Rational(1, 2));
  EXPECT_NEAR(dual_bound(relax_box(Judge(problem), box), {{2.0}, {0.0}}).least_cost, -0.5, 1e-12);
}

// Neither conditions that are judged at points, nor those of which nothing is known.
TEST(Relaxation, LeavesOutWhatSaysNothing) {
  const Box box{{0, 10}};
  Problem problem{{"x"},
                  box,
                  {{"at points", "c", "", kX - 5.0, false, false},
                   {"unknown", "c", "", 1.0 / kX},
                   {"useful", "c", "", kX - 1.0}},
                  {},
                  {"goal", "", kX, false, true}};
  const Relaxation relaxation = relax_box(Judge(problem), box);
  ASSERT_EQ(relaxation.conditions.size(), 1u);
  EXPECT_EQ(relaxation.conditions[0].condition, 2u);
  EXPECT_NEAR(relaxation.conditions[0].scale, 9.0, 1e-12);
  EXPECT_NEAR(relaxation.gain_scale, 10.0, 1e-12);
}

}  // namespace
}  // namespace torquewright::optimization
