// SPDX-License-Identifier: Apache-2.0
// Each constraint with angles or roots just inside and just outside its limit, and the exact ties.
#include <gtest/gtest.h>

#include "tests/oracles/rule_checks.hpp"

namespace torquewright::oracles {
namespace {

using gearbox::Problem;

// A convergent of pi/12, the carrier clearance of four planets as large as the sun: pi/12 is
// 0.26179938779914943654 and the fraction is 7.2e-17 more.
const Rational kPiTwelfth(21390802, 81706845);

TEST(RealRules, CarrierClearanceOfThePublishedDesignIsFifteenDegrees) {
  // Oracle: equation (6): pi/4 - asin(44/88) = pi/12.
  Problem problem = generous(4, 20);
  problem.min_carrier_clearance_rad = kPiTwelfth - Rational(1, 1000000000);
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), "carrier_clearance"));
  problem.min_carrier_clearance_rad = kPiTwelfth + Rational(1, 1000000000);
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), "carrier_clearance"));
}

TEST(RealRules, NearTieIsReported) {
  Problem problem = paper_problem({40, 40, 30}, kPiTwelfth);
  const Enumeration result = enumerate(problem);
  ASSERT_EQ(result.near_ties.size(), 1u);
  EXPECT_EQ(result.near_ties[0].constraint, "carrier_clearance");
  EXPECT_EQ(result.near_ties[0].design.teeth.sun, 44);
}

TEST(RealRules, SixPlanetsAsLargeAsTheSunTouchTheCarrierLimitExactly) {
  // Oracle: pi/6 - asin(1/2) = 0 >= 0.
  Problem problem = generous(6, 20);
  problem.min_carrier_clearance_rad = 0;
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), "carrier_clearance"));
  EXPECT_TRUE(violates(problem, zero_shift(43, 44, 32), "carrier_clearance"));
}

TEST(RealRules, NeighbourClearanceOfFourPlanets) {
  // Oracle: hand: 2 0.3 88 sin 45 - 0.6 46 = 9.7352 mm, and with P2 = 32: 16.9352 mm.
  Problem problem = generous(4, 20);
  problem.min_neighbour_clearance_mm = Rational(97352) / 10000 - Rational(1, 1000);
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), "neighbour_clearance.layer_1"));
  problem.min_neighbour_clearance_mm += Rational(1, 500);
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), "neighbour_clearance.layer_1"));
  problem.min_neighbour_clearance_mm += Rational(36, 5) - Rational(1, 500);
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), "neighbour_clearance.layer_2"));
  problem.min_neighbour_clearance_mm += Rational(1, 500);
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), "neighbour_clearance.layer_2"));
}

TEST(RealRules, SixPlanetsThatTouchDoNotClear) {
  // Oracle: with sin(pi/6) = 1/2 the clearance is m ((S + P)/2 - P - 2): 0 for S = P + 4.
  Problem problem = generous(6, 20);
  problem.module_mm = {Rational(3, 10)};
  EXPECT_TRUE(violates(problem, zero_shift(44, 40, 32), "neighbour_clearance.layer_1"));
  EXPECT_FALSE(violates(problem, zero_shift(45, 40, 32), "neighbour_clearance.layer_1"));
  // Half a tooth of 0.3 mm is 0.15 mm: not more than a limit of the same.
  problem.min_neighbour_clearance_mm = Rational(3, 20);
  EXPECT_TRUE(violates(problem, zero_shift(45, 40, 32), "neighbour_clearance.layer_1"));
  problem.min_neighbour_clearance_mm = Rational(149, 1000);
  EXPECT_FALSE(violates(problem, zero_shift(45, 40, 32), "neighbour_clearance.layer_1"));
}

TEST(RealRules, UndercutBeginsBelowEighteenTeeth) {
  // Oracle: gearbox.md section 4: "x = 0 limit z = 17.1".
  for (const char* name : {"undercut.sun", "undercut.planet_1", "undercut.planet_2"}) {
    EXPECT_FALSE(violates(generous(4, 20), zero_shift(18, 18, 18), name));
    EXPECT_TRUE(violates(generous(4, 20), zero_shift(17, 17, 17), name));
  }
}

TEST(RealRules, RingTipLeavesTheBaseCircleAtThirtyFourTeeth) {
  // Oracle: z - 2 > z cos 20, that is z > 2/(1 - 0.9396926) = 33.16.
  for (const char* name : {"ring_tip.fixed_ring", "ring_tip.output_ring"}) {
    EXPECT_FALSE(violates(generous(4, 20), {10, 12, 12, 34, 34}, name));
    EXPECT_TRUE(violates(generous(4, 20), {10, 12, 12, 33, 33}, name));
  }
}

TEST(RealRules, InterferenceByTheRulesOfThumb) {
  // Oracle: gearbox.md section 5: 24 teeth need a ring of 40, 25 one of 38; 30/39 is free of
  // trochoid interference, 30/38 is not.
  const Problem problem = generous(4, 20);
  const std::string involute = "interference.involute.";
  EXPECT_FALSE(violates(problem, {9, 24, 25, 40, 38}, involute + "planet_1_fixed_ring"));
  EXPECT_FALSE(violates(problem, {9, 24, 25, 40, 38}, involute + "planet_2_output_ring"));
  EXPECT_TRUE(violates(problem, {9, 24, 25, 39, 37}, involute + "planet_1_fixed_ring"));
  EXPECT_TRUE(violates(problem, {9, 24, 25, 39, 37}, involute + "planet_2_output_ring"));
  const std::string trochoid = "interference.trochoid.";
  EXPECT_FALSE(violates(problem, {9, 30, 30, 39, 38}, trochoid + "planet_1_fixed_ring"));
  EXPECT_TRUE(violates(problem, {9, 30, 30, 39, 38}, trochoid + "planet_2_output_ring"));
  EXPECT_TRUE(violates(problem, {9, 30, 30, 38, 39}, trochoid + "planet_1_fixed_ring"));
  EXPECT_FALSE(violates(problem, {9, 30, 30, 38, 39}, trochoid + "planet_2_output_ring"));
}

// eps 1.922 and 1.897 of the ring meshes: gearbox.md section 5. The sun's mesh of 44 on 44 teeth:
// 2 44 (sqrt((46/(44 cos 20))^2 - 1) - tan 20)/(2 pi) = 1.7317 by hand.
TEST(RealRules, ContactRatioOfThePublishedActuator) {
  const std::vector<std::pair<std::string, Rational>> ratios{
      {"contact_ratio.sun_planet_1", Rational(17317) / 10000},
      {"contact_ratio.planet_1_fixed_ring", Rational(1922) / 1000},
      {"contact_ratio.planet_2_output_ring", Rational(1897) / 1000}};
  Problem problem = generous(4, 20);
  for (const auto& [name, ratio] : ratios) {
    problem.min_contact_ratio = ratio - Rational(1, 1000);
    EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), name));
    problem.min_contact_ratio = ratio + Rational(1, 1000);
    EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), name));
  }
}

// Oracle: docs/gearbox_constraints.md, column "sets". 12/24/14 is 20:1 with three planets.
TEST(RealRules, PaperKnowsOnlyItsOwnEquations) {
  Problem problem = generous(3, 20);
  problem.ring_outer_diameter_mm = 1;
  problem.min_contact_ratio = 9;
  EXPECT_FALSE(violates(problem, zero_shift(12, 24, 14), "equal_spacing"));
  EXPECT_TRUE(violates(problem, zero_shift(12, 24, 14), "undercut.sun"));
  problem.constraints = gearbox::ConstraintSet::kPaper;
  EXPECT_TRUE(violations(problem, {zero_shift(12, 24, 14), 3, problem.module_mm.at(0)}).empty());
}

}  // namespace
}  // namespace torquewright::oracles
