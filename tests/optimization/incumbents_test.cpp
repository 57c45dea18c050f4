// SPDX-License-Identifier: Apache-2.0
// The best points found. Oracle: sorting all that was offered.
#include "optimization/discrete/incumbents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

Judge judge_of(bool exact) {
  const Expression x = Expression::variable(0);
  return Judge(Problem{{"x"}, {{0, 1000}}, {}, {}, {"goal", "", x, false, exact}});
}

struct Offer {
  std::size_t alternative;
  std::int64_t x;
  Rational cost;

  auto key() const { return std::tie(cost, alternative, x); }
  friend bool operator<(const Offer& a, const Offer& b) { return a.key() < b.key(); }
  friend bool operator==(const Offer& a, const Offer& b) { return a.key() == b.key(); }
};

void offer(Incumbents& incumbents, const Offer& what) {
  incumbents.offer({what.alternative, {what.x}, PreciseInterval(what.cost)});
}

std::vector<std::pair<std::size_t, std::int64_t>> list(const Incumbents& incumbents) {
  std::vector<std::pair<std::size_t, std::int64_t>> result;
  for (const Solution& solution : incumbents.solutions()) {
    result.emplace_back(solution.alternative, solution.point[0]);
  }
  return result;
}

/// The `wanted` cheapest, and those that cost no more than the last of them times 1 + tie.
std::vector<std::pair<std::size_t, std::int64_t>> expected(std::vector<Offer> offers,
                                                           std::size_t wanted,
                                                           const Rational& tie) {
  std::sort(offers.begin(), offers.end());
  offers.erase(std::unique(offers.begin(), offers.end()), offers.end());
  std::vector<std::pair<std::size_t, std::int64_t>> result;
  for (const Offer& each : offers) {
    const bool is_wanted = result.size() < wanted;
    if (!is_wanted && each.cost > offers[wanted - 1].cost * (1 + tie)) break;
    result.emplace_back(each.alternative, each.x);
  }
  return result;
}

TEST(Incumbents, AreTheBestInAnyOrderOfFinding) {
  const Judge judge = judge_of(true);
  Dice dice(121);
  for (int trial = 0; trial < 500; ++trial) {
    Incumbents incumbents(judge, static_cast<std::size_t>(1 + trial % 4));
    std::vector<Offer> offers;
    for (std::int64_t count = dice.between(1, 30); count > 0; --count) {
      const std::int64_t x = dice.between(0, 12);
      offers.push_back({static_cast<std::size_t>(dice.between(0, 2)), x, Rational(x / 3)});
      offer(incumbents, offers.back());
    }
    ASSERT_EQ(list(incumbents), expected(offers, static_cast<std::size_t>(1 + trial % 4), 0));
  }
}

// Costs that differ by less than 1e-12 from their neighbours, in long chains: the cheapest stays
// the first, and the list does not depend on the order of finding.
TEST(Incumbents, ChainsOfNearTiesDoNotHideTheBest) {
  const Judge judge = judge_of(false);
  const Rational tie(1, 1'000'000'000'000);
  Dice dice(122);
  for (int trial = 0; trial < 300; ++trial) {
    const auto wanted = static_cast<std::size_t>(1 + trial % 3);
    Incumbents incumbents(judge, wanted);
    std::vector<Offer> offers;
    for (std::int64_t count = dice.between(1, 25); count > 0; --count) {
      const std::int64_t x = dice.between(0, 15);
      offers.push_back({0, x, 1 + tie * Rational(x * 7 % 16) * 3 / 10});
      offer(incumbents, offers.back());
    }
    ASSERT_EQ(list(incumbents), expected(offers, wanted, tie));
  }
}

TEST(Incumbents, CeilingComesWithTheLastWanted) {
  const Judge judge = judge_of(true);
  Incumbents incumbents(judge, 2);
  offer(incumbents, {0, 1, 5});
  EXPECT_EQ(incumbents.ceiling(), HUGE_VAL);
  offer(incumbents, {0, 1, 5});  // the same again
  EXPECT_EQ(incumbents.ceiling(), HUGE_VAL);
  offer(incumbents, {0, 2, 9});
  EXPECT_EQ(incumbents.ceiling(), 9.0);
  offer(incumbents, {0, 3, 7});
  EXPECT_EQ(incumbents.ceiling(), 7.0);
  offer(incumbents, {0, 4, 8});
  EXPECT_EQ(incumbents.ceiling(), 7.0);
  EXPECT_EQ(incumbents.solutions().size(), 2u);
}

TEST(Incumbents, ABetterOneReplacesAllTies) {
  const Judge judge = judge_of(true);
  Incumbents incumbents(judge, 1);
  for (const std::int64_t x : {3, 1, 2}) offer(incumbents, {0, x, 5});
  EXPECT_EQ(list(incumbents),
            (std::vector<std::pair<std::size_t, std::int64_t>>{{0, 1}, {0, 2}, {0, 3}}));
  offer(incumbents, {1, 9, 4});
  EXPECT_EQ(list(incumbents), (std::vector<std::pair<std::size_t, std::int64_t>>{{1, 9}}));
  EXPECT_EQ(incumbents.ceiling(), 4.0);
}

TEST(Incumbents, NoneFoundNoCeiling) {
  const Judge judge = judge_of(true);
  const Incumbents incumbents(judge, 1);
  EXPECT_TRUE(incumbents.solutions().empty());
  EXPECT_EQ(incumbents.ceiling(), HUGE_VAL);
}

}  // namespace
}  // namespace torquewright::optimization
