// SPDX-License-Identifier: Apache-2.0
// Searches that are stopped: what they know is true, and they do not call it the optimum. Oracle:
// all points of the domain.
#include <gtest/gtest.h>

#include <cmath>

#include "optimization/discrete/branch_and_bound.hpp"
#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

void expect_true(const Toy& toy, const SearchResult& result) {
  const std::vector<Point> points = brute_force(toy);
  const Judge judge(toy.problem);
  for (const Solution& solution : result.solutions) {
    ASSERT_TRUE(toy.is_feasible(solution.point));
    ASSERT_LE(result.bound, solution.cost.outward().upper);
  }
  if (result.status == SearchStatus::kComplete) {
    ASSERT_EQ(result.solutions.empty(), points.empty());
  }
  if (points.empty()) return;
  const Interval least = judge.cost_at(points.front()).outward();
  ASSERT_LE(result.bound, least.upper);
  if (result.status == SearchStatus::kComplete) {
    ASSERT_EQ(result.solutions.front().point, points.front());
  }
}

SearchResult run(const Toy& toy, const SearchOptions& options) {
  const std::vector<Judge> judges{Judge(toy.problem)};
  return minimise(judges, options);
}

TEST(Limits, ANodeLimitLeavesATrueBound) {
  Dice dice(141);
  int limits = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Toy toy = random_toy(dice, 14);
    for (const RelaxationUse use : {RelaxationUse::kNever, RelaxationUse::kAlways}) {
      SearchOptions options;
      options.relaxation = use;
      options.max_nodes = dice.between(1, 6);
      const SearchResult result = run(toy, options);
      ASSERT_NO_FATAL_FAILURE(expect_true(toy, result));
      ASSERT_LE(result.nodes, options.max_nodes);
      limits += result.status == SearchStatus::kLimit ? 1 : 0;
    }
  }
  EXPECT_GT(limits, 20);
}

// However many nodes it takes: with one less the search ends at its limit.
TEST(Limits, IsCompleteOnlyWhenNothingIsOpen) {
  for (const Toy& toy : {whole_points_of_a_circle(), square_over_linear(), without_solution()}) {
    SearchOptions options;
    options.relaxation = RelaxationUse::kNever;
    const std::int64_t nodes = run(toy, options).nodes;
    ASSERT_GT(nodes, 1) << toy.name;
    options.max_nodes = nodes;
    EXPECT_EQ(run(toy, options).status, SearchStatus::kComplete) << toy.name;
    options.max_nodes = nodes - 1;
    EXPECT_EQ(run(toy, options).status, SearchStatus::kLimit) << toy.name;
  }
}

TEST(Limits, WithoutAnyNodeTheBoundIsAtLeastThatOfTheDomain) {
  const Toy toy = square_over_linear();
  SearchOptions options;
  options.max_nodes = 0;
  const SearchResult result = run(toy, options);
  EXPECT_EQ(result.status, SearchStatus::kLimit);
  EXPECT_TRUE(result.solutions.empty());
  // x^2/y + y with x and y in 1..100: at least 1/100 + 1, and at most what the best point has.
  EXPECT_GE(result.bound, 1.01 - 1e-12);
  ASSERT_NO_FATAL_FAILURE(expect_true(toy, result));
}

TEST(Limits, StopsWhenTold) {
  const Toy toy = whole_points_of_a_circle();
  SearchOptions options;
  int asked = 0;
  options.should_stop = [&] { return ++asked > 1; };
  const SearchResult result = run(toy, options);
  EXPECT_EQ(result.status, SearchStatus::kLimit);
  EXPECT_EQ(result.nodes, 1);
  ASSERT_NO_FATAL_FAILURE(expect_true(toy, result));
}

// The bound that is reported on the way is true, too, and best costs only fall.
TEST(Limits, ReportsOnTheWayAreTrue) {
  Dice dice(142);
  int reported_searches = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Toy toy = random_toy(dice, 14);
    const std::vector<Point> points = brute_force(toy);
    SearchOptions options;
    options.relaxation = RelaxationUse::kNever;
    int reports = 0;
    options.report = [&](const Progress& progress) {
      ++reports;
      ASSERT_LE(progress.bound, progress.best_cost);
      if (points.empty()) return;
      const Interval least = Judge(toy.problem).cost_at(points.front()).outward();
      ASSERT_LE(progress.bound, least.upper);
    };
    const SearchResult result = run(toy, options);
    // A search of one node is one that propagation closed at once.
    EXPECT_TRUE(reports >= 1 || result.nodes == 1);
    if (reports > 0) ++reported_searches;
  }
  EXPECT_GT(reported_searches, 20);
}

}  // namespace
}  // namespace torquewright::optimization
