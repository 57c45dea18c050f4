// SPDX-License-Identifier: Apache-2.0
// Which reserve is kept. Oracle: the best of all reserves of the ladder's grid, counted by hand for
// a made-up planner.
#include "hopper/planning/search/reserve_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "hopper/planning/tasks/reserve.hpp"

namespace torquewright::hopper {
namespace {

/// Plans up to a reserve, of which so many of 100 trials succeed.
struct MadeUpPlanner {
  double last_plan = 0.0;
  std::map<int, std::size_t> by_hundredths;  ///< Of the reserve; others: none succeeds.
  std::map<int, int> asked = {};
  bool is_stopped = false;

  ReserveChoice search(double least) {
    return search_reserve(
        least, {[this](double reserve) {
                  ++asked[static_cast<int>(std::lround(100.0 * reserve))];
                  PlanResult result;
                  result.status = reserve <= last_plan + 1e-9 ? PlanStatus::kPlanned
                                                              : PlanStatus::kLocallyInfeasible;
                  result.objective = reserve;
                  return result;
                },
                [this](const PlanResult& plan) {
                  const auto at =
                      by_hundredths.find(static_cast<int>(std::lround(100.0 * plan.objective)));
                  return TrialCounts{at == by_hundredths.end() ? 0 : at->second, 100, 0};
                },
                [this] { return is_stopped; }});
  }
};

TEST(ReserveSearch, KeepsTheOneThatMostTrialsDo) {
  MadeUpPlanner planner{0.1, {{0, 10}, {4, 40}, {6, 60}, {8, 55}, {10, 50}}};
  const ReserveChoice choice = planner.search(0.0);
  ASSERT_TRUE(choice.chosen);
  EXPECT_NEAR(choice.tried[*choice.chosen].reserve, 0.06, 1e-12);
  for (std::size_t i = 1; i < choice.tried.size(); ++i) {
    EXPECT_GT(choice.tried[i].reserve, choice.tried[i - 1].reserve);
  }
  for (const auto& [reserve, times] : planner.asked) EXPECT_EQ(times, 1) << reserve;
  EXPECT_FALSE(choice.tried.back().trials);  // 0.12 has no plan
}

TEST(ReserveSearch, FindsTheEndOfWhatCanBePlanned) {
  MadeUpPlanner planner{0.1, {{8, 70}, {10, 80}}};
  const ReserveChoice choice = planner.search(0.0);
  EXPECT_NEAR(choice.tried[choice.chosen.value()].reserve, 0.1, 1e-12);
}

TEST(ReserveSearch, OfSeveralKeepsTheCheapest) {
  MadeUpPlanner planner{0.5, {{2, 90}, {4, 90}, {8, 90}}};
  const ReserveChoice choice = planner.search(0.02);
  EXPECT_EQ(choice.tried[choice.chosen.value()].reserve, 0.02);
  EXPECT_LE(choice.tried.back().reserve, greatest_reserve());
  EXPECT_NO_THROW(with_reserve(greatest_reserve()));
}

TEST(ReserveSearch, HasAnAnswerThoughItIsStoppedAtOnce) {
  MadeUpPlanner planner{0.5, {{2, 90}, {6, 95}}};
  planner.is_stopped = true;
  const ReserveChoice choice = planner.search(0.02);
  ASSERT_EQ(choice.tried.size(), 1u);
  EXPECT_EQ(choice.tried[choice.chosen.value()].reserve, 0.02);
}

TEST(ReserveSearch, ChoosesNoneWhereNothingIsPlanned) {
  MadeUpPlanner planner{-1.0, {}};
  const ReserveChoice choice = planner.search(0.0);
  EXPECT_FALSE(choice.chosen);
  ASSERT_EQ(choice.tried.size(), 1u);
}

}  // namespace
}  // namespace torquewright::hopper
