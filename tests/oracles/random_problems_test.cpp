// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/random_problems.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <stdexcept>

#include "tests/oracles/gearbox_enumeration.hpp"
#include "tests/oracles/named_problems.hpp"

namespace torquewright::oracles {
namespace {

using gearbox::Design;
using gearbox::Problem;

constexpr std::uint64_t kSeed = 20;

std::map<std::vector<std::int64_t>, long double> as_set(const Problem& problem,
                                                        const std::vector<Found>& designs) {
  std::map<std::vector<std::int64_t>, long double> set;
  for (const Found& found : designs) {
    std::vector<std::int64_t> key = to_design(problem, found).teeth;
    key.push_back(found.planet_count);
    key.push_back(static_cast<std::int64_t>(found.module_index));
    set[key] = found.objective;
  }
  return set;
}

// Oracle: the naive loops, which try every triple and derive nothing.
TEST(Loops, InverseFindsWhatTheNaiveOnesFind) {
  for (const Problem& problem : random_problems(kSeed, 150)) {
    const Enumeration naive = enumerate(problem, Loops::kAll);
    const Enumeration inverse = enumerate(problem, Loops::kInverse);
    EXPECT_EQ(naive.feasible.size(), as_set(problem, naive.feasible).size());
    EXPECT_EQ(naive.feasible.size(), inverse.feasible.size()) << problem.name;
    EXPECT_EQ(as_set(problem, naive.feasible), as_set(problem, inverse.feasible)) << problem.name;
    EXPECT_EQ(as_set(problem, naive.best), as_set(problem, inverse.best)) << problem.name;
  }
}

// The problems are worth solving only if the root form decides some of them.
TEST(RandomProblems, RootFormDecidesSomeOfThem) {
  int stated = 0, decided = 0;
  for (const Problem& problem : random_problems(kSeed, 200)) {
    if (!problem.cutters.hob_tip_radius && !problem.cutters.shaper_teeth) continue;
    ++stated;
    const Enumeration with = enumerate(problem);
    const Enumeration without = enumerate(problem, Loops::kInverse, {"root_form"});
    decided += as_set(problem, with.best) != as_set(problem, without.best) ? 1 : 0;
  }
  std::cout << stated << " of 200 state a cutter, of which the root form decides " << decided
            << "\n";
  EXPECT_GT(stated, 40);
  EXPECT_GE(decided, 5);
}

// Likewise for what addenda add, and for the shaper's way into its ring.
TEST(RandomProblems, AddendaAndFeedDecideSomeOfThem) {
  int addenda = 0, fed = 0, feed_decided = 0, decided = 0;
  for (Problem problem : random_problems(kSeed, 300, Addenda::kSomeStated)) {
    const Enumeration with = enumerate(problem);
    EXPECT_TRUE(with.near_ties.empty()) << problem.name;
    if (problem.cutters.shaper_teeth) {
      ++fed;
      const Enumeration without = enumerate(problem, Loops::kInverse, {"shaper_feed"});
      feed_decided += as_set(problem, with.best) != as_set(problem, without.best) ? 1 : 0;
    }
    if (!problem.cutters.hob_addendum && !problem.cutters.shaper_addendum) continue;
    ++addenda;
    problem.cutters.hob_addendum.reset();
    problem.cutters.shaper_addendum.reset();
    decided += as_set(problem, with.best) != as_set(problem, enumerate(problem).best) ? 1 : 0;
  }
  std::cout << addenda << " of 300 state an addendum, which decides " << decided << "; " << fed
            << " a shaper, whose feed decides " << feed_decided << "\n";
  EXPECT_GT(addenda, 60);
  EXPECT_GE(decided, 15);
  EXPECT_GE(feed_decided, 3);
}

TEST(Loops, InverseFindsWhatTheNaiveOnesFindInAWideBore) {
  for (const Rational& tolerance : {Rational(0), Rational(1, 100)}) {
    Problem problem = paper_problem({12, 12, 12}, 0);
    problem.module_mm = {1};
    problem.rotor_inner_diameter_mm = 300;
    problem.ratio_tolerance = tolerance;
    const Enumeration naive = enumerate(problem, Loops::kAll);
    EXPECT_EQ(as_set(problem, naive.feasible), as_set(problem, enumerate(problem).feasible));
    EXPECT_FALSE(naive.feasible.empty());
  }
}

// A tolerance of 1 or more leaves no lower limit, a negative ratio no design at all.
TEST(Loops, InverseAtTheEdgesOfTheRatio) {
  Problem problem = paper_problem({1, 1, 1}, 0);
  for (const Rational& tolerance : {Rational(1), Rational(3, 2)}) {
    problem.ratio_tolerance = tolerance;
    EXPECT_EQ(enumerate(problem, Loops::kAll).feasible.size(), enumerate(problem).feasible.size());
  }
  problem.target_ratio = -20;
  for (const Rational& tolerance : {Rational(0), Rational(1, 2), Rational(1), Rational(3, 2)}) {
    problem.ratio_tolerance = tolerance;
    EXPECT_EQ(enumerate(problem, Loops::kAll).feasible.size(), enumerate(problem).feasible.size());
  }
}

// Oracle: docs/certificate.md: values count as equal below a relative difference of 1e-12. All
// these designs are 20:1, so the rotor's 400 kg m^2 are common to them. The gears lie within a
// cylinder of 86 mm and 20 mm, 1.2e-4 m^3, and turn no faster than the sun: at most 2.2e-7 of the
// rotor's share for each kg/m^3. That is below 1e-12 at 1e-7 kg/m^3, and far above it at 0.1.
TEST(Ties, BeginBelowOneInAMillionMillions) {
  Problem problem = paper_problem({12, 12, 12}, 0);
  problem.objective = gearbox::Objective::kReflectedInertia;
  problem.face_width_mm = {{"layer_1", 10}, {"layer_2", 10}};
  problem.rotor_inertia_kg_m2 = 1;
  problem.density_kg_m3 = Rational(1, 10);
  EXPECT_EQ(enumerate(problem).best.size(), 1u);
  problem.density_kg_m3 = Rational(1, 10000000);
  const Enumeration result = enumerate(problem);
  EXPECT_EQ(result.best.size(), result.feasible.size());
  EXPECT_GT(result.best.size(), 10u);
}

// Oracle: equation (1) in fractions: of two modules that differ by 1e-13 the coarser one leaves the
// ring less short of the bore, by some 1e-11 teeth. Long doubles take that for a tie.
TEST(Ties, OfThePaperCostAreExact) {
  Problem problem = paper_problem({12, 12, 12}, 0);
  problem.rotor_inner_diameter_mm = 100;
  problem.module_mm = {1, 1 + Rational(1, 10000000000000)};
  const Enumeration result = enumerate(problem);
  ASSERT_EQ(result.best.size(), 1u);
  EXPECT_EQ(result.best[0].module_index, 1u);
}

TEST(Loops, RefuseToGuess) {
  const Problem problem = d151_problem();
  EXPECT_THROW(enumerate(problem, Loops::kAll, {"rotor_bore"}), std::invalid_argument);
  EXPECT_THROW(enumerate(problem, Loops::kInverse, {"ratio"}), std::invalid_argument);
  EXPECT_THROW(enumerate(problem, Loops::kInverse, {"tooth_difference"}), std::invalid_argument);
}

// The mixture that a comparison needs, and that no point hangs on a rounded margin.
TEST(RandomProblems, ManyAreFeasibleAndManyAreNot) {
  std::size_t feasible = 0, infeasible = 0, near_ties = 0, tied = 0;
  std::map<int, int> objectives;
  for (const Problem& problem : random_problems(kSeed, 1000)) {
    const Enumeration result = enumerate(problem);
    ++(result.best.empty() ? infeasible : feasible);
    near_ties += result.near_ties.size();
    tied += result.best.size() > 1;
    ++objectives[static_cast<int>(problem.objective)];
  }
  std::cout << feasible << " feasible, " << infeasible << " infeasible, " << tied
            << " with more than one best, " << near_ties << " near-ties\n";
  EXPECT_GE(feasible, 300u);
  EXPECT_GE(infeasible, 200u);
  EXPECT_EQ(near_ties, 0u);
  EXPECT_EQ(objectives.size(), 6u);
}

TEST(RandomProblems, SeedDecides) {
  const auto first = random_problems(3, 40), again = random_problems(3, 40);
  const auto other = random_problems(4, 40);
  bool different = false;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].target_ratio, again[i].target_ratio);
    EXPECT_EQ(first[i].min_teeth, again[i].min_teeth);
    different = different || first[i].min_teeth != other[i].min_teeth;
  }
  EXPECT_TRUE(different);
}

// Oracle: gearbox_problem: decimals; six significant digits carry the ratio.
TEST(RandomProblems, NumbersAreShortDecimals) {
  for (const Problem& problem : random_problems(kSeed, 1000)) {
    const Rational millis = problem.target_ratio * 1000;
    EXPECT_EQ(millis.get_den(), 1) << problem.name;
    EXPECT_LT(millis, 1000000) << problem.name;
    EXPECT_EQ(Rational(problem.rotor_inner_diameter_mm * 100).get_den(), 1) << problem.name;
  }
}

}  // namespace
}  // namespace torquewright::oracles
