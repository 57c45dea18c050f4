// SPDX-License-Identifier: Apache-2.0
// Whole claims that are false, each with the best proof that can be made for it.
#include <gtest/gtest.h>

#include "gearbox/proof/result/certificate.hpp"
#include "tests/gearbox/proof/naive_result.hpp"

namespace torquewright::gearbox::proof_test {
namespace {

bool accepted(const Problem& problem, const Json& result) {
  return proof::check_certificate(problem, result).accepted;
}

Json& first_nodes(Json& result) {
  return result["certificate"]["claims"][0]["alternatives"][0]["nodes"];
}

/// Index of the node after the subtree that starts at `index`.
std::size_t end_of_subtree(const Json& nodes, std::size_t index) {
  std::size_t pending = 1;
  while (pending > 0) pending += nodes[index++].contains("split") ? 1U : std::size_t(-1);
  return index;
}

std::size_t first_split(const Json& nodes) {
  std::size_t index = 0;
  while (!nodes[index].contains("split")) ++index;
  return index;
}

/// The result without its `gone`-th design, with a proof made for what is left.
Json without_design(const Problem& problem, std::size_t gone) {
  Json result = naive_optimum(problem, 3, {});
  result["designs"].erase(gone);
  result["objective"] = result["bound"] = result["designs"][0]["objective"];
  result["certificate"]["claims"][0] = naive_claim(plain_optimum(problem, result), {});
  return result;
}

TEST(Lies, AWorseDesignIsNotOptimal) {
  EXPECT_FALSE(accepted(d151_tolerant(), without_design(d151_tolerant(), 0)));
  EXPECT_FALSE(accepted(d151_tolerant(), without_design(d151_tolerant(), 1)));
  EXPECT_TRUE(accepted(d151_tolerant(), without_design(d151_tolerant(), 2)));  // two best remain
}

TEST(Lies, AnEfficientDesignIsNotForgotten) {
  EXPECT_FALSE(accepted(most_efficient(), without_design(most_efficient(), 0)));
}

TEST(Lies, AFeasibleProblemIsNotInfeasible) {
  const Problem problem = d151();
  Json result = naive_infeasible(d151_infeasible(), {}, {});
  ASSERT_TRUE(accepted(d151_infeasible(), result));
  EXPECT_FALSE(accepted(problem, result));
  // With a tree made for the feasible problem and for all constraints.
  PlainClaim claim{&problem, "infeasible", constraint_names(problem), "", {}, {}, "", 0};
  result["certificate"]["claims"][0] = naive_claim(claim, {});
  result["conflict"] = Json::array();
  for (const std::string& name : constraint_names(problem)) {
    result["conflict"].push_back({{"constraint", name}, {"without_it", nullptr}});
  }
  EXPECT_FALSE(accepted(problem, result));
}

TEST(Lies, AConflictHoldsOnlyWhatItNeeds) {
  Json result = naive_infeasible(d151_infeasible(), {}, {});
  // One constraint fewer: its witness is a design that satisfies all the others.
  result["conflict"].erase(0);
  auto& names = result["certificate"]["claims"][0]["constraints"];
  names.erase(0);
  EXPECT_FALSE(accepted(d151_infeasible(), result));
}

// A proof for a sharp hob and an unrounded shaper, handed in for rounder ones: no ring's tip leaves
// room for a hob of 0.38, and a shaper of 12 teeth does not reach what a large planet's tip asks.
TEST(Lies, TheRootFormIsNotForgotten) {
  Problem problem = buildable_inertia();
  problem.cutters = {Rational(1, 10), Rational(0), 60};
  const Json result = naive_optimum(problem, 1, {});
  ASSERT_TRUE(accepted(problem, result));
  Problem blunt_hob = problem, blunt_shaper = problem;
  blunt_hob.cutters.hob_tip_radius = Rational(19, 50);
  EXPECT_FALSE(accepted(blunt_hob, result));
  blunt_shaper.cutters.shaper_teeth = 12;
  blunt_shaper.cutters.shaper_tip_radius = Rational(1, 4);
  EXPECT_FALSE(accepted(blunt_shaper, result));
}

// Every design is worse than, or violates something with, one that only the root form forbids.
TEST(Lies, ADesignThatNoHobCutsIsNotOptimal) {
  Problem sharp = buildable_inertia(), blunt = sharp;
  sharp.cutters.hob_tip_radius = Rational(0);
  blunt.cutters.hob_tip_radius = Rational(1, 4);
  const Json result = naive_optimum(sharp, 1, {});
  const Json honest = naive_optimum(blunt, 1, {});
  ASSERT_NE(result["designs"], honest["designs"]);
  EXPECT_TRUE(accepted(blunt, honest));
  Json forged = honest;
  forged["designs"] = result["designs"];
  EXPECT_FALSE(accepted(blunt, forged));
}

TEST(Lies, EveryAlternativeNeedsATree) {
  const Problem problem = planetary_8();
  const Json result = naive_optimum(problem, 2, {});
  ASSERT_TRUE(accepted(problem, result));
  for (std::size_t i = 0; i < 4; ++i) {
    Json fewer = result;
    fewer["certificate"]["claims"][0]["alternatives"].erase(i);
    EXPECT_FALSE(accepted(problem, fewer)) << i;
  }
}

TEST(Lies, TheChildrenOfASplitAreNotInterchangeable) {
  Json result = naive_optimum(d151_tolerant(), 1, {});
  Json& nodes = first_nodes(result);
  const std::size_t split = first_split(nodes);
  const std::size_t middle = end_of_subtree(nodes, split + 1);
  const std::size_t end = end_of_subtree(nodes, middle);
  const auto at = [&](std::size_t i) { return nodes.begin() + static_cast<std::ptrdiff_t>(i); };
  std::rotate(at(split + 1), at(middle), at(end));
  EXPECT_FALSE(accepted(d151_tolerant(), result));
}

TEST(Lies, ASplitLeavesNothingOut) {
  const Problem problem = d151_tolerant();
  const Json result = naive_optimum(problem, 1, {});
  Json nodes = result["certificate"]["claims"][0]["alternatives"][0]["nodes"];
  const std::size_t split = first_split(nodes);
  const std::size_t middle = end_of_subtree(nodes, split + 1);
  const std::size_t end = end_of_subtree(nodes, middle);
  const auto erase = [&](std::size_t from, std::size_t to) {
    Json fewer = nodes;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(from),
                fewer.begin() + static_cast<std::ptrdiff_t>(to));
    Json changed = result;
    first_nodes(changed) = fewer;
    return changed;
  };
  EXPECT_FALSE(accepted(problem, erase(split + 1, middle)));
  EXPECT_FALSE(accepted(problem, erase(middle, end)));
  // A split at an end of the range would make an empty child, and one beyond it no children at all.
  for (const int value : {0, 1000}) {
    Json changed = result;
    first_nodes(changed)[split]["split"][1] = value;
    EXPECT_FALSE(accepted(problem, changed));
  }
}

// Designs with the same sun have the same hollow shaft: the last one shown ties with some.
TEST(Lies, TiesAreNamed) {
  Problem problem = d151_tolerant();
  problem.objective = Objective::kHollowShaft;
  problem.min_teeth["sun"] = 20;
  problem.min_teeth["planet_1"] = 20;
  problem.min_teeth["planet_2"] = 20;
  problem.ratio_tolerance = Rational(1, 5);
  Json result = naive_optimum(problem, 1, {});
  for (std::size_t shown = 2; result["ties"].empty() && shown < 20; ++shown) {
    result = naive_optimum(problem, shown, {});
  }
  ASSERT_FALSE(result["ties"].empty());
  ASSERT_TRUE(accepted(problem, result));
  Json fewer = result;
  fewer["ties"].erase(0);
  EXPECT_FALSE(accepted(problem, fewer));
}

TEST(Lies, ARingLimitDoesNotHideDesigns) {
  Problem problem = d151_infeasible();
  problem.min_carrier_clearance_rad = Rational(78, 100);  // of pi/4 = 0.785
  problem.min_teeth["planet_1"] = 60;
  Json result = naive_infeasible(problem, {}, {});
  ASSERT_TRUE(accepted(problem, result));
  const auto limit = result["certificate"]["claims"][0]["ring_limit"];
  for (const Json& lie : {Json(0), Json(1), Json(131), Json(199), Json(10000000)}) {
    if (lie == limit) continue;
    result["certificate"]["claims"][0]["ring_limit"] = lie;
    EXPECT_FALSE(accepted(problem, result)) << lie;
  }
}

TEST(Lies, AnEmptyRangeProvesNothing) {
  Json result = naive_infeasible(d151_infeasible(), {}, {});
  first_nodes(result) = Json::array();
  EXPECT_FALSE(accepted(d151_infeasible(), result));
}

// The bore 79.4/0.6 = 132.33 holds rings up to 132: the best ring has exactly these.
TEST(Lies, TheRangeReachesTheLargestRing) {
  Problem problem = planetary_8();
  problem.module_mm = {Rational(1)};
  problem.planet_count = {4};
  problem.objective = Objective::kHollowShaft;
  problem.constraints = ConstraintSet::kPaper;
  problem.min_teeth = {{"sun", 40}, {"planet", 1}};
  problem.min_carrier_clearance_rad = Rational(1, 1000);
  problem.target_ratio = Rational(4);
  problem.ratio_tolerance = Rational(1, 4);
  problem.rotor_inner_diameter_mm = 80;
  const Json result = naive_optimum(problem, 1, {4096, false, false});
  EXPECT_EQ(result["designs"][0]["teeth"]["ring"], 80);
  EXPECT_TRUE(accepted(problem, result));
}

TEST(Lies, ALimitNeedsAnOpenLeafAndATrueBound) {
  const Problem problem = d151_tolerant();
  const Json result = naive_limit(problem, 0.875, {});
  EXPECT_TRUE(proof::check_certificate(problem, result).undecided);
  ASSERT_TRUE(accepted(problem, result));
  EXPECT_FALSE(accepted(problem, naive_limit(problem, 1.001, {})));

  Json closed = naive_optimum(problem, 1, {});
  closed["status"] = "limit";
  EXPECT_FALSE(accepted(problem, closed));

  Json none_shown = result;
  none_shown["designs"] = Json::array();
  none_shown["objective"] = none_shown["gap"] = nullptr;
  none_shown["certificate"]["claims"][0]["reference"] = nullptr;
  none_shown["certificate"]["claims"][0]["alternatives"][0]["nodes"] = {{{"closed", "open"}}};
  none_shown["bound"] = 10000.0;
  EXPECT_TRUE(accepted(problem, none_shown));
  none_shown["bound"] = result["objective"].get<double>() * 1.0001;
  EXPECT_FALSE(accepted(problem, none_shown));
}

TEST(Lies, ANeededBoundIsTheDesigns) {
  const Problem problem = d151_infeasible();
  const Json result = naive_infeasible(problem, {"/min_carrier_clearance_rad"}, {});
  ASSERT_TRUE(accepted(problem, result));
  for (const double factor : {1 + 1e-11, 1 - 1e-11, 0.5}) {
    Json changed = result;
    double needed = changed["would_be_feasible_with"][0]["needed"];
    changed["would_be_feasible_with"][0]["needed"] = needed * factor;
    EXPECT_FALSE(accepted(problem, changed)) << factor;
  }
}

}  // namespace
}  // namespace torquewright::gearbox::proof_test
