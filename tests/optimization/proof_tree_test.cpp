// SPDX-License-Identifier: Apache-2.0
// The tree that a search leaves behind says why no other point is better. Oracle: every claim of
// it, checked on all points of the box it is about, in exact fractions.
#include "optimization/discrete/proof_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "optimization/discrete/branch_and_bound.hpp"
#include "tests/optimization/toy_problems.hpp"

namespace torquewright::optimization {
namespace {

struct Count {
  int cuts = 0, splits = 0, empty = 0, enumerated = 0, relaxation = 0, open = 0;
};

/// Checks a tree, and gathers the points that it leaves to be looked at.
class Replay {
 public:
  Replay(const Toy& toy, const SearchResult& result, Count& count)
      : toy_(toy), judge_(toy.problem), tree_(result.proofs.at(0)), count_(count) {
    if (!result.solutions.empty()) worst_ = toy.cost(result.solutions.back().point);
  }

  void check(std::size_t place, Box box) {
    const ProofNode& node = tree_.at(place);
    for (const Cut& cut : node.cuts) {
      Range& range = box[cut.variable];
      Box slab = box;
      (cut.is_lower ? slab[cut.variable].upper : slab[cut.variable].lower) =
          cut.is_lower ? cut.value - 1 : cut.value + 1;
      expect_refuted(slab, cut.condition);
      (cut.is_lower ? range.lower : range.upper) = cut.value;
      ++count_.cuts;
    }
    switch (node.leaf) {
      case Leaf::kOpen:
        ++count_.open;
        return;
      case Leaf::kSplit:
        return check_split(node, box);
      case Leaf::kEmpty:
        ++count_.empty;
        return expect_refuted(box, node.condition);
      case Leaf::kEnumerated:
        ++count_.enumerated;
        for (const Point& point : all_points(box)) seen_.push_back(point);
        return;
      case Leaf::kRelaxation:
        ++count_.relaxation;
        return check_relaxation(node, box);
    }
  }

  const std::vector<Point>& seen() const { return seen_; }

 private:
  void check_split(const ProofNode& node, const Box& box) {
    ++count_.splits;
    Box first = box, second = box;
    first[node.split_variable].upper = node.split_value;
    second[node.split_variable].lower = node.split_value + 1;
    ASSERT_FALSE(all_points(first).empty() || all_points(second).empty());
    check(node.children[0], first);
    check(node.children[1], second);
  }

  // No condition alone, but those named together: no point satisfies them all. The relaxed
  // conditions are concave, so any of their sums is negative on the whole box, and on its points.
  void check_relaxation(const ProofNode& node, const Box& box) {
    for (std::size_t i = 0; i < box.size(); ++i) {
      ASSERT_TRUE(box[i].interval().contains(node.point[i]));
    }
    for (const Multiplier& multiplier : node.multipliers) {
      ASSERT_TRUE(std::isfinite(multiplier.value) && multiplier.value > 0.0);
    }
    for (const Point& point : all_points(box)) {
      bool is_possible = true;
      for (const Multiplier& multiplier : node.multipliers) {
        is_possible = is_possible && (multiplier.condition == kQuantity
                                          ? is_good(point)
                                          : judge_.holds(multiplier.condition, point));
      }
      ASSERT_FALSE(is_possible && toy_.is_feasible(point));
    }
  }

  // Good: at least as good as the last that was listed.
  bool is_good(const Point& point) const { return !worst_ || toy_.cost(point) <= *worst_; }

  void expect_refuted(const Box& box, std::size_t condition) {
    for (const Point& point : all_points(box)) {
      if (condition == kQuantity) {
        ASSERT_FALSE(toy_.is_feasible(point) && is_good(point));
      } else {
        ASSERT_FALSE(judge_.holds(condition, point));
      }
    }
  }

  const Toy& toy_;
  Judge judge_;
  const ProofTree& tree_;
  Count& count_;
  std::optional<Rational> worst_;
  std::vector<Point> seen_;
};

SearchResult search(const Toy& toy, RelaxationUse use, std::int64_t max_nodes) {
  const std::vector<Judge> judges{Judge(toy.problem)};
  SearchOptions options;
  options.relaxation = use;
  options.max_nodes = max_nodes;
  return minimise(judges, options);
}

TEST(ProofTree, EveryClaimHolds) {
  Dice dice(161);
  Count count;
  for (int trial = 0; trial < 120; ++trial) {
    const bool is_convex = trial % 4 == 0;
    const Toy toy = is_convex ? convex_toy(dice, 14) : random_toy(dice, 12);
    const auto use = is_convex ? RelaxationUse::kAlways : RelaxationUse::kNever;
    const SearchResult result = search(toy, use, 1'000'000);
    Replay replay(toy, result, count);
    replay.check(0, toy.problem.domain);
    ASSERT_FALSE(testing::Test::HasFailure()) << "trial " << trial;
    for (const Solution& solution : result.solutions) {
      const auto& seen = replay.seen();
      ASSERT_NE(std::find(seen.begin(), seen.end(), solution.point), seen.end());
    }
  }
  EXPECT_EQ(count.open, 0);
  EXPECT_GT(count.cuts, 200);
  EXPECT_GT(count.splits, 50);
  EXPECT_GT(count.empty, 40);
  EXPECT_GT(count.enumerated, 40);
  EXPECT_GT(count.relaxation, 3);
}

// A search that was stopped leaves open leaves, and only such a one.
TEST(ProofTree, WhatALimitLeavesIsOpen) {
  Dice dice(162);
  int limits = 0;
  for (int trial = 0; trial < 80; ++trial) {
    const Toy toy = random_toy(dice, 14);
    const SearchResult result = search(toy, RelaxationUse::kNever, 3);
    Count count;
    // Boxes were closed against a ceiling of then, which is no lower than that of now.
    Replay(toy, result, count).check(0, toy.problem.domain);
    ASSERT_EQ(count.open > 0, result.status == SearchStatus::kLimit);
    limits += count.open > 0 ? 1 : 0;
  }
  EXPECT_GT(limits, 10);
}

}  // namespace
}  // namespace torquewright::optimization
