// SPDX-License-Identifier: Apache-2.0
// Each constraint just inside and just outside its limit. Teeth are S, P1, P2, F, O.
#include "tests/oracles/gearbox_rules.hpp"

#include <gtest/gtest.h>

#include "tests/oracles/rule_checks.hpp"

namespace torquewright::oracles {
namespace {

using gearbox::Problem;

struct Published {
  std::vector<std::int64_t> teeth;
  Rational ratio;
  std::int64_t planets;
  bool identical;
};

// gearbox.md section 12: seed 001, Matsuki table III, PGS manual, SplitRingGears, derived there.
TEST(GearboxRules, PublishedRatiosAndAssemblies) {
  const std::vector<Published> rows{{{44, 44, 32, 132, 120}, 20, 4, true},
                                    {{12, 39, 32, 90, 81}, Rational(5967) / 62, 3, true},
                                    {{12, 39, 20, 90, 54}, Rational(117, 2), 3, true},
                                    {{8, 13, 11, 34, 29}, Rational(2639) / 4, 3, true},
                                    {{44, 42, 31, 128, 117}, Rational(2457) / 121, 4, false}};
  for (const Published& row : rows) {
    const Problem problem = generous(row.planets, row.ratio);
    EXPECT_FALSE(violates(problem, row.teeth, "ratio")) << row.ratio;
    EXPECT_FALSE(violates(problem, row.teeth, "equal_spacing")) << row.ratio;
    EXPECT_EQ(violates(problem, row.teeth, "identical_planets"), !row.identical) << row.ratio;
  }
}

// The same section's decimals, to check the fractions above: they are read off the sources' text.
TEST(GearboxRules, PublishedDecimalsOfTheRatios) {
  EXPECT_NEAR(Rational(5967, 62).get_d(), 96.24193548, 5e-9);
  EXPECT_EQ(Rational(2639, 4).get_d(), 659.75);
  EXPECT_NEAR(Rational(2457, 121).get_d(), 20.3058, 5e-5);
}

// COMPAct's table (gearbox.md section 12): zero shift, so equation (5) must give the same.
TEST(GearboxRules, WillisIsEquationFiveWithoutProfileShift) {
  const std::vector<std::pair<Teeth, Rational>> rows{{complete_3k(64, 48, 28), Rational(21) / 2},
                                                     {complete_3k(72, 42, 30), 14},
                                                     {complete_3k(63, 35, 28), 20},
                                                     {complete_3k(54, 36, 30), Rational(80) / 3},
                                                     {complete_3k(28, 40, 32), Rational(250) / 7},
                                                     {complete_3k(36, 32, 28), Rational(128) / 3},
                                                     {complete_3k(60, 48, 44), Rational(304) / 5}};
  for (const auto& [z, ratio] : rows) {
    const auto [p, q] = ratio_3k(z);
    EXPECT_EQ(compare(p, q, narrow(ratio)), 0) << ratio;
    EXPECT_EQ(2 * z.planet_1 * z.output_ring * ratio.get_den().get_si(),
              z.sun * (z.planet_1 - z.planet_2) * ratio.get_num().get_si());
  }
}

TEST(GearboxRules, SingleStageRatios) {
  const std::vector<std::pair<Teeth, Rational>> rows{
      {complete_planetary(25, 65), Rational(36) / 5},
      {complete_planetary(23, 52), Rational(150) / 23},
      {complete_planetary(12, 12), 4}};
  for (const auto& [z, ratio] : rows) {
    const auto [p, q] = ratio_planetary(z);
    EXPECT_EQ(compare(p, q, narrow(ratio)), 0) << ratio;
  }
}

TEST(GearboxRules, RatioLimitsBelongToTheRange) {
  // 46/40/30 has 2 40 116/(46 10) = 464/23; as a tolerance on 20 that is 1/115.
  Problem problem = generous(4, 20);
  problem.ratio_tolerance = Rational(1, 115);
  EXPECT_FALSE(violates(problem, zero_shift(46, 40, 30), "ratio"));
  problem.ratio_tolerance = Rational(1, 115) - Rational(1, 1000000000);
  EXPECT_TRUE(violates(problem, zero_shift(46, 40, 30), "ratio"));
  // 48/44/32 lies below: 2 44 124/(48 12) = 341/18, short of 20 by 19/360.
  problem.ratio_tolerance = Rational(19, 360);
  EXPECT_FALSE(violates(problem, zero_shift(48, 44, 32), "ratio"));
  problem.ratio_tolerance = Rational(19, 360) - Rational(1, 1000000000);
  EXPECT_TRUE(violates(problem, zero_shift(48, 44, 32), "ratio"));
}

TEST(GearboxRules, RatioIsSigned) {
  // gearbox_problem: 20 is not met by -20, nor the other way round, at any tolerance below 2.
  Problem problem = generous(4, -20);
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), "ratio"));
  problem.ratio_tolerance = Rational(1, 2);
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), "ratio"));
  // 44/32/44 turns backwards: 2 32 120/(44 (32 - 44)) = -160/11.
  EXPECT_FALSE(violates(generous(4, Rational(-160) / 11), zero_shift(44, 32, 44), "ratio"));
  EXPECT_TRUE(violates(generous(4, Rational(160) / 11), zero_shift(44, 32, 44), "ratio"));
}

TEST(GearboxRules, SmallestGears) {
  Problem problem = generous(4, 20);
  problem.min_teeth = {{"sun", 44}, {"planet_1", 44}, {"planet_2", 32}};
  for (const char* name : {"min_teeth.sun", "min_teeth.planet_1", "min_teeth.planet_2"}) {
    EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), name));
    EXPECT_TRUE(violates(problem, zero_shift(43, 43, 31), name));
  }
}

TEST(GearboxRules, RotorBoreTouches) {
  Problem problem = generous(4, 20);
  problem.rotor_inner_diameter_mm = Rational(396, 5);  // 132 teeth of 0.6 mm
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), "rotor_bore"));
  problem.rotor_inner_diameter_mm = Rational(7919, 100);
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), "rotor_bore"));
}

TEST(GearboxRules, ToothDifferenceAndSunUnderLayerTwo) {
  const Problem problem = generous(4, 20);
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 40), "tooth_difference"));
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 41), "tooth_difference"));
  // m ((P1 - P2)/2 - 2) > 0, strictly.
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 40), "sun_under_layer_2"));
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 39), "sun_under_layer_2"));
  Problem beside = problem;
  beside.sun_under_second_layer = false;
  EXPECT_FALSE(violates(beside, zero_shift(44, 44, 40), "sun_under_layer_2"));
}

TEST(GearboxRules, EqualSpacing) {
  EXPECT_FALSE(violates(generous(4, 20), zero_shift(44, 44, 32), "equal_spacing"));
  EXPECT_TRUE(violates(generous(4, 20), zero_shift(45, 44, 32), "equal_spacing"));
  EXPECT_TRUE(violates(generous(5, 20), zero_shift(44, 44, 32), "equal_spacing"));
}

TEST(GearboxRules, RingWall) {
  // (90 - 0.6 (132 + 2.5))/2 = 4.65 mm behind the fixed ring, (90 - 0.6 122.5)/2 = 8.25 mm.
  Problem problem = generous(4, 20);
  problem.ring_outer_diameter_mm = 90;
  problem.ring_wall_mm = Rational(93, 20);
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), "ring_wall.fixed_ring"));
  problem.ring_wall_mm = Rational(233, 50);
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), "ring_wall.fixed_ring"));
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), "ring_wall.output_ring"));
  problem.ring_wall_mm = Rational(413, 50);
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), "ring_wall.output_ring"));
  // Without a wall one tooth height, 1.35 mm: the ring needs 0.6 134.5 + 2.7 = 83.4 mm.
  problem.ring_wall_mm.reset();
  problem.ring_outer_diameter_mm = Rational(417, 5);
  EXPECT_FALSE(violates(problem, zero_shift(44, 44, 32), "ring_wall.fixed_ring"));
  problem.ring_outer_diameter_mm = Rational(8339, 100);
  EXPECT_TRUE(violates(problem, zero_shift(44, 44, 32), "ring_wall.fixed_ring"));
}

}  // namespace
}  // namespace torquewright::oracles
