// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/gearbox_objectives.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracles/named_problems.hpp"
#include "tests/oracles/reals.hpp"

namespace torquewright::oracles {
namespace {

using gearbox::Problem;

constexpr double kRounding = 1e-15;

Efficiencies of_d151(const Rational& friction) {
  Problem problem = d151_problem();
  problem.friction_coefficient = friction;
  return efficiencies(problem, complete_3k(44, 44, 32));
}

// Oracle: gearbox.md section 12: with the general Lambda at mu = 0.08 .9568/.9552.
TEST(GearboxObjectives, EfficiencyOfThePublishedActuator) {
  const Efficiencies eta = of_d151(Rational(2, 25));
  EXPECT_NEAR(static_cast<double>(eta.forward), .9568, 5e-5);
  EXPECT_NEAR(static_cast<double>(eta.backward), .9552, 5e-5);
}

// Oracle: the same section's basic efficiencies (five decimals, short Lambda) and what follows from
// them. The weight 4.0 of the output meshes turns 5e-6 into some 4e-5.
TEST(GearboxObjectives, EfficiencyFromPublishedMeshes) {
  const Efficiencies eta = efficiencies(true, complete_3k(44, 44, 32), .99452L, .99776L, .99666L);
  EXPECT_NEAR(static_cast<double>(eta.forward), .97251, 5e-5);
  EXPECT_NEAR(static_cast<double>(eta.backward), .97189, 5e-5);
}

// Oracle: COMPAct's published table at mu = 0.3 (gearbox.md section 12), which agrees with the
// formulas within 1e-3 where the approach ratios stay below one; 36/32/28 is quoted there with the
// general Lambda as .6737/.5372.
TEST(GearboxObjectives, EfficiencyOfCompactsTrain) {
  Problem problem = d151_problem();
  problem.friction_coefficient = Rational(3, 10);
  const Efficiencies eta = efficiencies(problem, complete_3k(36, 32, 28));
  EXPECT_NEAR(static_cast<double>(eta.forward), .6737, 5e-5);
  EXPECT_NEAR(static_cast<double>(eta.backward), .5372, 5e-5);
}

// Oracle: docs/derivations/efficiency.md, "What transmits nothing". A ring's tip lies inside its
// base circle below 33.16 teeth. Sun 40, planet 1: e_A + e_R = .784 + .425, so Lambda > 1/2, and .9
// pi (1 + 1/40) Lambda > 1: friction takes all power.
TEST(GearboxObjectives, EfficiencyIsZeroWhereAMeshPassesNothing) {
  Problem problem = d151_problem();
  problem.friction_coefficient = Rational(1, 10);
  EXPECT_EQ(efficiencies(problem, complete_3k(9, 12, 11)).forward, 0);   // F = 33
  EXPECT_EQ(efficiencies(problem, complete_3k(10, 12, 11)).forward, 0);  // O = 33
  EXPECT_GT(efficiencies(problem, complete_3k(11, 12, 11)).forward, 0);
  problem.topology = "planetary";
  EXPECT_EQ(efficiencies(problem, complete_planetary(2, 2)).backward, 0);
  EXPECT_GT(efficiencies(problem, complete_planetary(40, 1)).backward, 0);
  problem.friction_coefficient = Rational(9, 10);
  EXPECT_EQ(efficiencies(problem, complete_planetary(40, 1)).backward, 0);
}

// Oracle: single stage 25/65/155 at mu = .3: .9595 (gearbox.md section 12; short Lambda, whose
// difference to the general one stays below the published table's 1e-3).
TEST(GearboxObjectives, EfficiencyOfASingleStage) {
  Problem problem = d151_problem();
  problem.topology = "planetary";
  problem.friction_coefficient = Rational(3, 10);
  const Efficiencies eta = efficiencies(problem, complete_planetary(25, 65));
  EXPECT_NEAR(static_cast<double>(eta.forward), .9595, 1e-3);
}

// Oracle: power balance with the carrier as reference (Mueller's rule, gearbox.md section 6): the
// rolling powers are T_S I1, -T_F and -T_O I2 at a carrier speed of 1, with T_S + T_F + T_O = 0.
// For I2 < 1 the sun and the output ring put power in, the fixed ring takes what the meshes leave:
// a b T_S I1 - T_F - b c T_O I2 = 0, solved here for the output torque at T_S = 1.
TEST(GearboxObjectives, ForwardEfficiencyBalancesPower) {
  const Teeth z = complete_3k(44, 44, 32);
  const long double a = .98L, b = .99L, c = .97L;
  const long double i1 = 3, i2 = 132.0L * 32 / (44 * 120);
  const long double output = -(1 + a * b * i1) / (1 - b * c * i2);
  const long double power_in = 1 + i1, power_out = -output * (1 - i2);
  const Efficiencies eta = efficiencies(true, z, a, b, c);
  EXPECT_NEAR(static_cast<double>(eta.forward), static_cast<double>(power_out / power_in),
              kRounding);
}

// Oracle: section 6: self-locking if eta_b eta_c <= I2; here I2 = 0.8.
TEST(GearboxObjectives, SelfLockingBeginsWhereTheMeshesLoseWhatTheRingsDiffer) {
  const Teeth z = complete_3k(44, 44, 32);
  EXPECT_GT(efficiencies(true, z, 1, .801L, 1).backward, 0);
  EXPECT_LT(efficiencies(true, z, 1, 1, .799L).backward, 0);
  Problem problem = d151_problem();
  problem.objective = gearbox::Objective::kBackwardEfficiency;
  problem.friction_coefficient = 3;
  EXPECT_EQ(objective_value({problem, 4, problem.module_mm[0]}, z), 0);
}

// Oracle: gearbox.md section 10: root 24.9 mm, published 12 mm, hence 6.45 mm a side. Without a
// wall a rim of 2.25 x 0.6 mm is left.
TEST(GearboxObjectives, HollowShaftOfThePublishedActuator) {
  Problem problem = d151_problem();
  problem.objective = gearbox::Objective::kHollowShaft;
  const Setting setting{problem, 4, problem.module_mm[0]};
  EXPECT_NEAR(static_cast<double>(objective_value(setting, complete_3k(44, 44, 32))), 22.2,
              kRounding * 100);
  problem.hollow_shaft_wall_mm = Rational(129, 20);
  EXPECT_NEAR(static_cast<double>(objective_value(setting, complete_3k(44, 44, 32))), 12,
              kRounding * 100);
}

// Round figures for a hand calculation: 20/20/10, module 1 mm, faces 10 and 8 mm, wall 2.5 mm.
Problem hand_problem() {
  Problem problem = d151_problem();
  problem.module_mm = {1};
  problem.face_width_mm = {{"layer_1", 10}, {"layer_2", 8}};
  problem.density_kg_m3 = 2000;
  problem.ring_wall_mm = Rational(5, 2);
  return problem;
}

// Oracle: docs/gearbox_constraints.md by hand, in pi rho/4 and cubic millimetres: planets
// 3 (400 10 + 100 8) = 14400; k = 7.5; fixed ring 10 (67.5^2 - 60^2) = 9562.5; output ring
// 8 (57.5^2 - 50^2) = 6450; sun 10 (20^2 - 12.5^2) = 2437.5. Together 32850.
TEST(GearboxObjectives, MassByHand) {
  const Problem problem = hand_problem();
  const Setting setting{problem, 3, problem.module_mm[0]};
  EXPECT_NEAR(static_cast<double>(mass_kg(setting, complete_3k(20, 20, 10))),
              static_cast<double>(kPi / 4 * 2000 * 32850e-9L), kRounding);
}

// Oracle: the same with the default wall of 2.25 m, k = 7 mm, and a sun of 6 teeth without a hole:
// 14400 + 10 (67^2 - 60^2) + 8 (57^2 - 50^2) + 10 36 = 29642. A single stage has three planets of
// 4000, a ring of 8890 and a sun of 10 (20^2 - 13^2) = 2310.
TEST(GearboxObjectives, MassWithDefaultWallAndFullSun) {
  Problem problem = hand_problem();
  problem.ring_wall_mm.reset();
  const Setting setting{problem, 3, problem.module_mm[0]};
  EXPECT_NEAR(static_cast<double>(mass_kg(setting, Teeth{6, 20, 10, 60, 50})),
              static_cast<double>(kPi / 4 * 2000 * 29642e-9L), kRounding);
  problem.topology = "planetary";
  EXPECT_NEAR(static_cast<double>(mass_kg(setting, complete_planetary(20, 20))),
              static_cast<double>(kPi / 4 * 2000 * (12000 + 8890 + 2310) * 1e-9L), kRounding);
}

// Oracle: gearbox.md section 9: the D151's rotor alone is 0.000922 20^2 = 0.3688 kg m^2.
TEST(GearboxObjectives, RotorSeenFromTheOutput) {
  Problem problem = hand_problem();
  problem.density_kg_m3 = 0;
  problem.rotor_inertia_kg_m2 = Rational(461, 500000);
  const Setting setting{problem, 4, problem.module_mm[0]};
  EXPECT_NEAR(static_cast<double>(reflected_inertia_kg_m2(setting, complete_3k(44, 44, 32))),
              0.3688, kRounding);
}

// Oracle: kinetic energy at an output speed of 1, by hand for 20/20/10 with three planets, in
// pi rho/4 1e-15 kg m^2, d in mm: i = 2 20 50/(20 10) = 10, carrier 10/4 = 2.5, planets
// 2.5 (1 - 60/20) = -5. A body's b (D^2 - d^2)(D^2 + d^2)/8 = b (D^4 - d^4)/8.
TEST(GearboxObjectives, ReflectedInertiaIsTwiceTheKineticEnergy) {
  const Problem problem = hand_problem();
  const Setting setting{problem, 3, problem.module_mm[0]};
  const auto quartic = [](long double d) { return d * d * d * d; };
  const long double sun = 10 * (quartic(20) - quartic(12.5L)) / 8 * 10 * 10;
  const long double orbit = 3 * (4000 + 800) * 20.0L * 20 * 2.5L * 2.5L;
  const long double spin = 3 * (10 * quartic(20) + 8 * quartic(10)) / 8 * 5 * 5;
  const long double ring = 8 * (quartic(57.5L) - quartic(50)) / 8;
  const long double expected = kPi / 4 * 2000 * (sun + orbit + spin + ring) * 1e-15L;
  EXPECT_NEAR(static_cast<double>(reflected_inertia_kg_m2(setting, complete_3k(20, 20, 10))),
              static_cast<double>(expected), kRounding);
}

// Oracle: the same for a single stage 20/20/60: i = 4, carrier 1, planets 1 - 60/20 = -2.
TEST(GearboxObjectives, ReflectedInertiaOfASingleStage) {
  Problem problem = hand_problem();
  problem.topology = "planetary";
  const Setting setting{problem, 3, problem.module_mm[0]};
  const auto quartic = [](long double d) { return d * d * d * d; };
  const long double sun = 10 * (quartic(20) - quartic(12.5L)) / 8 * 4 * 4;
  const long double planets = 3 * (4000 * 20.0L * 20 + 10 * quartic(20) / 8 * 2 * 2);
  const long double expected = kPi / 4 * 2000 * (sun + planets) * 1e-15L;
  EXPECT_NEAR(static_cast<double>(reflected_inertia_kg_m2(setting, complete_planetary(20, 20))),
              static_cast<double>(expected), kRounding);
}

// Oracle: equation (1) by hand for the published design: 1/1936 + (132 - 397/3)^2 + 44^2 + 32^2 +
// 120^2 = 1/1936 + 1/9 + 17360.
TEST(GearboxObjectives, PaperCostIsAFraction) {
  const Problem problem = d151_problem();
  const Setting setting{problem, 4, problem.module_mm[0]};
  EXPECT_EQ(paper_cost(setting, complete_3k(44, 44, 32)),
            Rational(1, 1936) + Rational(1, 9) + 17360);
  EXPECT_NEAR(static_cast<double>(objective_value(setting, complete_3k(44, 44, 32))), 17360.1116,
              5e-5);
}

}  // namespace
}  // namespace torquewright::oracles
