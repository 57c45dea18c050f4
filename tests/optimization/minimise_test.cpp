// SPDX-License-Identifier: Apache-2.0
// Searches that run to their end. Oracle: all points of the domain, judged and compared in exact
// fractions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "optimization/discrete/branch_and_bound.hpp"
#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

constexpr RelaxationUse kUses[] = {RelaxationUse::kNever, RelaxationUse::kAuto,
                                   RelaxationUse::kAlways};

/// Of all feasible points, cheapest first, the `wanted` first and all ties with the last of them.
std::vector<Point> best_of(const Toy& toy, const std::vector<Point>& feasible, std::size_t wanted) {
  std::size_t count = std::min(wanted, feasible.size());
  while (count > 0 && count < feasible.size() &&
         toy.cost(feasible[count]) == toy.cost(feasible[wanted - 1])) {
    ++count;
  }
  return {feasible.begin(), feasible.begin() + static_cast<std::ptrdiff_t>(count)};
}

SearchResult run(const Toy& toy, std::size_t wanted, RelaxationUse use) {
  const std::vector<Judge> judges{Judge(toy.problem)};
  SearchOptions options;
  options.wanted = wanted;
  options.relaxation = use;
  return minimise(judges, options);
}

void expect_best(const Toy& toy, const SearchResult& result, const std::vector<Point>& best) {
  ASSERT_EQ(result.status, SearchStatus::kComplete) << toy.name;
  std::vector<Point> found;
  for (const Solution& solution : result.solutions) found.push_back(solution.point);
  ASSERT_EQ(found, best) << toy.name;
  if (best.empty()) {
    EXPECT_EQ(result.bound, HUGE_VAL);
  } else {
    const PreciseInterval least = Judge(toy.problem).cost_at(best.front());
    EXPECT_EQ(result.bound, least.outward().lower);
  }
}

class Toys : public testing::TestWithParam<RelaxationUse> {};

TEST_P(Toys, NamedOnesEndWithTheBest) {
  for (const Toy& toy : {knapsack(), whole_points_of_a_circle(), square_over_linear(),
                         without_solution(), with_ties()}) {
    const std::vector<Point> feasible = brute_force(toy);
    for (const std::size_t wanted : {1u, 2u, 5u, 200u}) {
      const SearchResult result = run(toy, wanted, GetParam());
      ASSERT_NO_FATAL_FAILURE(expect_best(toy, result, best_of(toy, feasible, wanted)));
    }
  }
}

TEST_P(Toys, RandomOnesEndWithTheBest) {
  Dice dice(131);
  const bool is_always = GetParam() == RelaxationUse::kAlways;
  const int trials = is_always ? 45 : 120;
  int infeasible = 0, solves = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Toy toy = trial % 3 == 0 ? convex_toy(dice, 16) : random_toy(dice, 12);
    const auto wanted = static_cast<std::size_t>(dice.between(1, 4));
    const std::vector<Point> feasible = brute_force(toy);
    const SearchResult result = run(toy, wanted, GetParam());
    ASSERT_NO_FATAL_FAILURE(expect_best(toy, result, best_of(toy, feasible, wanted))) << trial;
    infeasible += feasible.empty() ? 1 : 0;
    solves += static_cast<int>(result.relaxations);
  }
  EXPECT_GT(infeasible, trials / 20);
  EXPECT_LT(infeasible, trials * 2 / 3);
  if (GetParam() == RelaxationUse::kNever) {
    EXPECT_EQ(solves, 0);
  }
  if (is_always) {
    EXPECT_GT(solves, 50);
  }
}

// Debug optimum: a box that holds one of the best is closed only once that one is found, or while
// the ceiling admits it.
TEST_P(Toys, NoBoxOfTheBestIsClosedTooEarly) {
  Dice dice(133);
  for (int trial = 0; trial < 30; ++trial) {
    const Toy toy = trial % 2 == 0 ? convex_toy(dice, 14) : random_toy(dice, 12);
    const std::vector<Point> best = best_of(toy, brute_force(toy), 2);
    const std::vector<Judge> judges{Judge(toy.problem)};
    SearchOptions options;
    options.wanted = 2;
    options.relaxation = GetParam();
    options.on_close = [&](std::size_t, const Box& box, double ceiling) {
      for (const Point& point : best) {
        if (!lies_in(point, box)) continue;
        EXPECT_LE(judges[0].cost_around(point).lower, ceiling);
      }
    };
    minimise(judges, options);
  }
}

INSTANTIATE_TEST_SUITE_P(Minimise, Toys, testing::ValuesIn(kUses));

// The answers that the toys' comments state, by hand.
TEST(Minimise, FindsWhatIsKnownByHand) {
  const auto best = [](const Toy& toy) {
    return run(toy, 1, RelaxationUse::kAuto).solutions.at(0);
  };
  EXPECT_EQ(best(knapsack()).point, (Point{0, 1, 1, 1}));
  EXPECT_TRUE(agrees(best(knapsack()).cost, -21));
  EXPECT_EQ(best(whole_points_of_a_circle()).point, (Point{4, -3}));
  EXPECT_EQ(best(square_over_linear()).point, (Point{10, 10}));
  EXPECT_TRUE(agrees(best(square_over_linear()).cost, 20));
  EXPECT_EQ(run(with_ties(), 1, RelaxationUse::kAuto).solutions.size(), 11u);
  EXPECT_TRUE(run(without_solution(), 1, RelaxationUse::kAlways).solutions.empty());
}

// Two alternatives, one of them without any point, one in which every point costs 2 more.
TEST(Minimise, ComparesAlternatives) {
  Toy toy = whole_points_of_a_circle();
  Problem dearer = toy.problem, empty = toy.problem;
  dearer.goal.value = dearer.goal.value + 2.0;
  empty.domain[0] = {1, 0};
  const std::vector<Judge> judges{Judge(dearer), Judge(empty), Judge(toy.problem)};
  SearchOptions options;
  options.wanted = 2;
  const SearchResult result = minimise(judges, options);
  ASSERT_EQ(result.status, SearchStatus::kComplete);
  // 2 at (4, -3); (3, -4) and, 2 dearer, (4, -3) both cost 4.
  ASSERT_EQ(result.solutions.size(), 3u);
  EXPECT_EQ(result.solutions[0].alternative, 2u);
  EXPECT_EQ(result.solutions[1].alternative, 0u);
  EXPECT_EQ(result.solutions[1].point, (Point{4, -3}));
  EXPECT_EQ(result.solutions[2].point, (Point{3, -4}));
  EXPECT_TRUE(result.proofs[1].empty());
}

TEST(Minimise, OfNothingIsComplete) {
  const SearchResult result = minimise({}, {});
  EXPECT_EQ(result.status, SearchStatus::kComplete);
  EXPECT_TRUE(result.solutions.empty());
  EXPECT_EQ(result.bound, HUGE_VAL);
}

// Same input, same run.
TEST(Minimise, RepeatsItself) {
  Dice dice(132);
  for (int trial = 0; trial < 10; ++trial) {
    const Toy toy = random_toy(dice, 15);
    const SearchResult first = run(toy, 2, RelaxationUse::kAlways);
    const SearchResult again = run(toy, 2, RelaxationUse::kAlways);
    EXPECT_EQ(first.nodes, again.nodes);
    EXPECT_EQ(first.relaxations, again.relaxations);
    EXPECT_EQ(first.points_enumerated, again.points_enumerated);
  }
}

// Two costs that differ by half a tie: both are listed, and the bound is below both.
TEST(Minimise, BoundIsBelowEveryTie) {
  const Expression x = Expression::variable(0);
  const Rational half_a_tie(1, 2'000'000'000'000);
  const Problem problem{
      {"x"}, {{0, 1}}, {}, {}, {"goal", "", 1.0 - Expression(half_a_tie) * x, false, false}};
  const std::vector<Judge> judges{Judge(problem)};
  const SearchResult result = minimise(judges, {});
  ASSERT_EQ(result.solutions.size(), 2u);
  for (const Solution& solution : result.solutions) {
    EXPECT_LE(result.bound, solution.cost.outward().upper);
  }
}

// A point at which the goal has no value is no solution. The root is real from x = 3 on.
TEST(Minimise, PassesOverPointsWithoutACost) {
  const Expression x = Expression::variable(0);
  const Problem problem{{"x"}, {{0, 200}}, {}, {}, {"goal", "", sqrt(x - 3.0), false, false}};
  const std::vector<Judge> judges{Judge(problem)};
  for (const RelaxationUse use : kUses) {
    SearchOptions options;
    options.relaxation = use;
    const SearchResult result = minimise(judges, options);
    ASSERT_EQ(result.solutions.size(), 1u);
    EXPECT_EQ(result.solutions[0].point, Point{3});
  }
}

}  // namespace
}  // namespace torquewright::optimization
