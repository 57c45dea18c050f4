// SPDX-License-Identifier: Apache-2.0
// Halves and points of boxes. Oracle: sets of points.
#include "optimization/discrete/branching.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "optimization/discrete/enumeration.hpp"
#include "tests/optimization/boxes.hpp"
#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

TEST(Branching, HalvesShareTheBox) {
  Dice dice(101);
  for (int trial = 0; trial < 500; ++trial) {
    const Box box = draw_box(dice, 3, -9, 9, 6);
    if (point_count(box) <= 1.0) continue;
    const Split split = choose_split(box);
    std::vector<Point> points = all_points(first_half(box, split));
    const std::vector<Point> second = all_points(second_half(box, split));
    ASSERT_FALSE(points.empty() || second.empty());
    points.insert(points.end(), second.begin(), second.end());
    std::sort(points.begin(), points.end());
    ASSERT_EQ(points, all_points(box));
  }
}

TEST(Branching, CutsTheWidestRangeInTheMiddle) {
  const Split split = choose_split({{0, 3}, {-4, 5}, {7, 7}});
  EXPECT_EQ(split.variable, 1u);
  EXPECT_EQ(split.value, 0);
  EXPECT_EQ(choose_split({{3, 4}}).value, 3);
}

TEST(Enumeration, VisitsEveryPointOnceAndInOrder) {
  Dice dice(102);
  for (int trial = 0; trial < 200; ++trial) {
    const Box box = draw_box(dice, static_cast<std::size_t>(dice.between(1, 4)), -5, 5, 4);
    std::vector<Point> visited;
    for_each_point(box, [&](std::span<const std::int64_t> point) {
      visited.emplace_back(point.begin(), point.end());
    });
    ASSERT_EQ(visited, all_points(box));
    ASSERT_EQ(static_cast<double>(visited.size()), point_count(box));
  }
}

TEST(Enumeration, OfAnEmptyBoxVisitsNothing) {
  int visits = 0;
  for_each_point({{0, 3}, {2, 1}}, [&](std::span<const std::int64_t>) { ++visits; });
  EXPECT_EQ(visits, 0);
  EXPECT_EQ(point_count({{0, 3}, {2, 1}}), 0.0);
}

TEST(Enumeration, SmallEndsAtSixtyFour) {
  EXPECT_TRUE(is_small({{1, 8}, {1, 8}}));
  EXPECT_FALSE(is_small({{1, 5}, {1, 13}}));
  EXPECT_FALSE(is_small(Box(5, Range{0, 1'000'000'000'000})));
}

}  // namespace
}  // namespace torquewright::optimization
