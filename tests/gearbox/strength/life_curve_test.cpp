// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/life_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace torquewright::gearbox {
namespace {

GearMaterial steel(Treatment treatment) { return {treatment, 206e3, .3, 400, 1000, 900.0}; }

// Oracle: the printed exponents of DIN 3990-11, four digits: 0.2876 lg(static/endurance) from 1e3
// to 3e6 loads (5.06), 0.4037 from 1e4 (5.05), 0.3705 for flanks from 1e5 to 5e7 (4.05), 0.7686 for
// nitrided ones to 2e6 (4.10).
void expect_exponent(const LifeCurve& curve, double printed) {
  const double exponent = printed * std::log10(curve.static_MPa / curve.endurance_MPa);
  for (const double share : {.1, .5, .9}) {
    const double cycles =
        curve.static_cycles * std::pow(curve.endurance_cycles / curve.static_cycles, share);
    const double expected =
        curve.endurance_MPa * std::pow(curve.endurance_cycles / cycles, exponent);
    EXPECT_NEAR(curve.at_MPa(cycles) / expected, 1, 5e-4);
  }
}

TEST(LifeCurve, HasThePrintedExponents) {
  expect_exponent(root_life(steel(Treatment::kCaseHardened), 2, 1), .2876);
  expect_exponent(root_life(steel(Treatment::kCaseHardened), 1.7, .7), .2876);
  expect_exponent(root_life(steel(Treatment::kNitrided), 2, 1), .2876);
  expect_exponent(root_life(steel(Treatment::kThroughHardened), 2, 1), .4037);
  expect_exponent(flank_life(steel(Treatment::kCaseHardened)), .3705);
  expect_exponent(flank_life(steel(Treatment::kNitrided)), .7686);
}

TEST(LifeCurve, EndsAtStaticAndEnduranceStrength) {
  const LifeCurve curve{2000, 1e3, 800, 3e6};
  EXPECT_EQ(curve.at_MPa(1), 2000);
  EXPECT_EQ(curve.at_MPa(1e3), 2000);
  EXPECT_NEAR(curve.at_MPa(1e3 * (1 + 1e-12)), 2000, 1e-6);
  EXPECT_NEAR(curve.at_MPa(3e6 * (1 - 1e-12)), 800, 1e-6);
  EXPECT_EQ(curve.at_MPa(3e6), 800);
  EXPECT_EQ(curve.at_MPa(1e12), 800);
}

// Oracle: tables 4.3 and 5.2 of DIN 3990-11. A root like the reference gear's (Y_S = 2) has notch
// factor 1 whatever the steel.
TEST(StaticStrength, IsThatOfTheTables) {
  EXPECT_NEAR(root_life(steel(Treatment::kCaseHardened), 2, 1).static_MPa, 2 * 400 * 2.5, 1e-9);
  EXPECT_NEAR(root_life(steel(Treatment::kThroughHardened), 2, 1).static_MPa, 2 * 400 * 2.5, 1e-9);
  EXPECT_NEAR(root_life(steel(Treatment::kNitrided), 2, 1).static_MPa, 2 * 400 * 1.6, 1e-9);
  EXPECT_NEAR(flank_life(steel(Treatment::kCaseHardened)).static_MPa, 1600, 1e-9);
  EXPECT_NEAR(flank_life(steel(Treatment::kThroughHardened)).static_MPa, 1600, 1e-9);
  EXPECT_NEAR(flank_life(steel(Treatment::kNitrided)).static_MPa, 1300, 1e-9);
}

// By hand: .44 1.5 + .12 = .78; .2 1.5 + .6 = .9; yield 300: (1 + .82 .5)/1.82.
TEST(StaticStrength, OfAMilderNotchIsLower) {
  EXPECT_NEAR(root_life(steel(Treatment::kCaseHardened), 1.5, 1).static_MPa, 2000 * .78, 1e-9);
  EXPECT_NEAR(root_life(steel(Treatment::kNitrided), 1.5, 1).static_MPa, 1280 * .9, 1e-9);
  GearMaterial mild = steel(Treatment::kThroughHardened);
  mild.yield_MPa = 300.0;
  EXPECT_NEAR(root_life(mild, 1.5, 1).static_MPa, 2000 * 1.41 / 1.82, 1e-9);
}

TEST(EnduranceShare, LeavesTheStaticStrength) {
  const LifeCurve curve = root_life(steel(Treatment::kCaseHardened), 2, .7);
  EXPECT_NEAR(curve.endurance_MPa, 560, 1e-9);
  EXPECT_NEAR(curve.static_MPa, 2000, 1e-9);
}

}  // namespace
}  // namespace torquewright::gearbox
