// SPDX-License-Identifier: Apache-2.0
// Oracle: gearbox.md section 11 and minlp.md section 4, results of enumerations made
// independently of this one, for the D151: 20:1, rotor 79.4 mm, module 0.6 mm.
#include <gtest/gtest.h>

#include "tests/oracles/gearbox_enumeration.hpp"
#include "tests/oracles/gearbox_objectives.hpp"
#include "tests/oracles/named_problems.hpp"

namespace torquewright::oracles {
namespace {

using gearbox::Objective;
using gearbox::Problem;
using Counts = std::vector<std::int64_t>;

Counts counts(const Teeth& z) {
  return {z.sun, z.planet_1, z.planet_2, z.fixed_ring, z.output_ring};
}

struct Row {
  std::int64_t planets;
  std::int64_t least_teeth;
  std::size_t feasible;
  Counts cheapest;
  long double cost;
  Counts most_efficient;
  long double forward, backward;
  Counts widest;
  long double forward_of_widest;
};

// The table at the end of section 11; teeth in its order S, P1, P2, F, O.
const std::vector<Row> kTable{
    {3,
     12,
     16,
     {12, 24, 14, 60, 50},
     8504.118L,
     {12, 60, 16, 132, 88},
     .9730L,
     .9727L,
     {66, 24, 20, 114, 110},
     .8940L},
    {4,
     12,
     11,
     {16, 30, 18, 76, 64},
     8493.448L,
     {24, 48, 28, 120, 100},
     .9676L,
     .9670L,
     {54, 30, 24, 114, 108},
     .9238L},
    {4,
     17,
     7,
     {28, 24, 18, 76, 70},
     8973.446L,
     {24, 48, 28, 120, 100},
     .9676L,
     .9670L,
     {54, 30, 24, 114, 108},
     .9238L},
    {4,
     29,
     1,
     {44, 44, 32, 132, 120},
     17360.112L,
     {44, 44, 32, 132, 120},
     .9568L,
     .9552L,
     {44, 44, 32, 132, 120},
     .9568L},
};

// What the table does not enforce.
const Switches kTableOff{"undercut", "interference",      "contact_ratio",
                         "ring_tip", "sun_under_layer_2", "ring_wall"};

Problem table_problem(const Row& row, Objective objective) {
  Problem problem = paper_problem({row.least_teeth, row.least_teeth, row.least_teeth}, 0);
  problem.planet_count = {row.planets};
  problem.constraints = gearbox::ConstraintSet::kBuildable;
  problem.objective = objective;
  problem.friction_coefficient = Rational(2, 25);
  return problem;
}

Found only_best(const Problem& problem) {
  const Enumeration result = enumerate(problem, Loops::kInverse, kTableOff);
  EXPECT_EQ(result.best.size(), 1u);
  EXPECT_TRUE(result.near_ties.empty());
  return result.best.at(0);
}

TEST(PublishedAnswers, CountsAndCheapestDesigns) {
  for (const Row& row : kTable) {
    const Problem problem = table_problem(row, Objective::kPaperCost);
    EXPECT_EQ(enumerate(problem, Loops::kInverse, kTableOff).feasible.size(), row.feasible);
    const Found best = only_best(problem);
    EXPECT_EQ(counts(best.teeth), row.cheapest);
    EXPECT_NEAR(static_cast<double>(best.objective), static_cast<double>(row.cost), 5e-4);
  }
}

// Reference section 11: a few dozen designs of exactly 20:1 for three to six planets (minima 12, as
// in its table), and the published one has the greatest printed cost of all.
TEST(PublishedAnswers, ThePublishedDesignIsTheLastByItsOwnCost) {
  Problem problem = paper_problem({12, 12, 12}, 0);
  problem.planet_count = {3, 4, 5, 6};
  const Enumeration all = enumerate(problem);
  EXPECT_TRUE(all.near_ties.empty());
  EXPECT_EQ(all.feasible.size(), 39u);  // counted by a separate program too
  long double greatest = 0;
  for (const Found& found : all.feasible) greatest = std::max(greatest, found.objective);
  EXPECT_NEAR(static_cast<double>(greatest), 17360.112, 5e-4);
}

// Four printed decimals.
constexpr double kPrinted = 5e-5;

TEST(PublishedAnswers, MostEfficientDesigns) {
  for (const Row& row : kTable) {
    const Problem problem = table_problem(row, Objective::kForwardEfficiency);
    const Found best = only_best(problem);
    EXPECT_EQ(counts(best.teeth), row.most_efficient);
    const Efficiencies eta = efficiencies(problem, best.teeth);
    EXPECT_NEAR(static_cast<double>(eta.forward), static_cast<double>(row.forward), kPrinted);
    EXPECT_NEAR(static_cast<double>(eta.backward), static_cast<double>(row.backward), kPrinted);
    EXPECT_EQ(best.objective, eta.forward);
  }
}

TEST(PublishedAnswers, WidestHollowShafts) {
  for (const Row& row : kTable) {
    const Problem problem = table_problem(row, Objective::kHollowShaft);
    const Found best = only_best(problem);
    EXPECT_EQ(counts(best.teeth), row.widest);
    const Efficiencies eta = efficiencies(problem, best.teeth);
    EXPECT_NEAR(static_cast<double>(eta.forward), static_cast<double>(row.forward_of_widest),
                kPrinted);
  }
}

TEST(PublishedAnswers, ProblemsOnWhichASolverFailed) {
  for (const HardProblem& hard : hard_problems()) {
    const Enumeration result = enumerate(hard.problem);
    ASSERT_EQ(result.best.size(), 1u);
    EXPECT_EQ(counts(result.best[0].teeth), hard.teeth);
    const double cost = hard.teeth[0] == 44 ? 17360.1116 : 13240.1128;
    EXPECT_NEAR(static_cast<double>(result.best[0].objective), cost, 5e-5);
  }
}

TEST(PublishedAnswers, ToleranceMovesTheOptimum) {
  Problem problem = d151_problem();
  EXPECT_EQ(counts(enumerate(problem).best.at(0).teeth), (Counts{44, 44, 32, 132, 120}));
  problem.ratio_tolerance = Rational(1, 200);
  EXPECT_EQ(counts(enumerate(problem).best.at(0).teeth), (Counts{44, 44, 32, 132, 120}));
  problem.ratio_tolerance = Rational(1, 100);
  EXPECT_EQ(counts(enumerate(problem).best.at(0).teeth), (Counts{46, 40, 30, 126, 116}));
}

TEST(PublishedAnswers, FifteenDegreesIsTheLimit) {
  // pi/4 - asin(1/2) is pi/12: met at 14.999 degrees, missed at 15.001.
  EXPECT_EQ(enumerate(paper_problem({40, 40, 30}, Rational(13089) / 50000)).best.size(), 1u);
  EXPECT_TRUE(enumerate(paper_problem({40, 40, 30}, Rational(13091) / 50000)).best.empty());
}

}  // namespace
}  // namespace torquewright::oracles
