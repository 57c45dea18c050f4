// SPDX-License-Identifier: Apache-2.0
// Visits of all feasible points. Oracle: all points of the domain, judged in exact fractions.
#include <gtest/gtest.h>

#include <algorithm>

#include "optimization/discrete/branch_and_bound.hpp"
#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

struct Visits {
  VisitStatus status;
  std::vector<Point> points;
};

Visits visit(const std::vector<Judge>& judges, const VisitOptions& options, std::size_t most) {
  Visits visits{VisitStatus::kAll, {}};
  visits.status = for_each_feasible(
      judges, options, [&](std::size_t alternative, std::span<const std::int64_t> point) {
        visits.points.emplace_back(point.begin(), point.end());
        visits.points.back().push_back(static_cast<std::int64_t>(alternative));
        return visits.points.size() < most;
      });
  return visits;
}

std::vector<Point> expected(const Toy& toy, std::int64_t alternative) {
  std::vector<Point> points = brute_force(toy);
  for (Point& point : points) point.push_back(alternative);
  std::sort(points.begin(), points.end());
  return points;
}

TEST(FeasiblePoints, EveryOneIsVisitedOnce) {
  Dice dice(151);
  std::size_t count = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const Toy toy = random_toy(dice, 16);
    Visits visits = visit({Judge(toy.problem)}, {}, 1'000'000);
    ASSERT_EQ(visits.status, VisitStatus::kAll);
    std::sort(visits.points.begin(), visits.points.end());
    ASSERT_EQ(visits.points, expected(toy, 0));
    count += visits.points.size();
  }
  EXPECT_GT(count, 2000u);
}

TEST(FeasiblePoints, AlternativesComeInOrder) {
  const Toy circle = whole_points_of_a_circle(), ties = with_ties();
  const Visits visits = visit({Judge(circle.problem), Judge(ties.problem)}, {}, 1'000'000);
  ASSERT_EQ(visits.points.size(), 12u + 121u);
  EXPECT_EQ(visits.points[11].back(), 0);
  EXPECT_EQ(visits.points[12].back(), 1);
}

TEST(FeasiblePoints, StopsWhenTheVisitorHasEnough) {
  const Visits visits = visit({Judge(with_ties().problem)}, {}, 5);
  EXPECT_EQ(visits.status, VisitStatus::kStopped);
  EXPECT_EQ(visits.points.size(), 5u);
}

TEST(FeasiblePoints, LimitsAreTold) {
  const std::vector<Judge> judges{Judge(with_ties().problem)};
  VisitOptions few;
  few.max_boxes = 2;
  const Visits visits = visit(judges, few, 1'000'000);
  EXPECT_EQ(visits.status, VisitStatus::kLimit);
  EXPECT_LT(visits.points.size(), 121u);
  VisitOptions told;
  told.should_stop = [] { return true; };
  EXPECT_EQ(visit(judges, told, 1'000'000).status, VisitStatus::kLimit);
}

TEST(FeasiblePoints, OfAnEmptyDomainAreNone) {
  Toy toy = with_ties();
  toy.problem.domain[1] = {3, 2};
  const Visits visits = visit({Judge(toy.problem)}, {}, 1'000'000);
  EXPECT_EQ(visits.status, VisitStatus::kAll);
  EXPECT_TRUE(visits.points.empty());
}

}  // namespace
}  // namespace torquewright::optimization
