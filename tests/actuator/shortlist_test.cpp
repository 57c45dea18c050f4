// SPDX-License-Identifier: Apache-2.0
// Oracle: the line of a motor without losses, in closed form.
#include "actuator/catalogue/shortlist.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

// 200 Nm at rest and up to 6 rad/s; at 9 rad/s (50 - 45)/0.5 A: 50 Nm.
TEST(Shortlist, TakesTheLeastMarginOfAllNeeds) {
  Wanted wanted{{{100.0, 1.0}, {40.0, 9.0}}, {}, {}, {}};
  const Suitability found = suitability(round_actuator(), wanted);
  EXPECT_TRUE(found.fits);
  EXPECT_NEAR(*found.margin_share, 50.0 / 40.0 - 1.0, 1e-9);
  wanted.needs.push_back({80.0, 9.0});
  const Suitability missing = suitability(round_actuator(), wanted);
  EXPECT_FALSE(missing.fits);
  EXPECT_NEAR(*missing.margin_share, 50.0 / 80.0 - 1.0, 1e-9);
  ASSERT_EQ(missing.reasons.size(), 1u);
  EXPECT_EQ(missing.reasons.front(), "50 of 80 Nm at 9 rad/s (voltage)");
}

// Braking at 9 rad/s is by the current: 200 Nm.
TEST(Shortlist, ASignAgainstTheSpeedBrakes) {
  const Suitability found = suitability(round_actuator(), {{{-160.0, 9.0}}, {}, {}, {}});
  EXPECT_NEAR(*found.margin_share, 200.0 / 160.0 - 1.0, 1e-9);
}

TEST(Shortlist, SaysWhatADocumentDoesNotState) {
  const Suitability found = suitability(round_actuator(), {{{1.0, 1.0}}, 5.0, 3.0, {}});
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(found.is_unknown);
  EXPECT_FALSE(found.margin_share);
  EXPECT_EQ(found.reasons, (std::vector<std::string>{"states no torque or current that may last",
                                                     "states no mass"}));
}

// 20 A may last: 100 Nm at rest.
TEST(Shortlist, AsksWhatMayLastAndWhatItWeighs) {
  Actuator drive = round_actuator();
  drive.drive.continuous_current_A = 20.0;
  drive.mass_kg = 2.0;
  EXPECT_TRUE(suitability(drive, {{{1.0, 1.0}}, 99.0, 2.1, {}}).fits);
  EXPECT_FALSE(suitability(drive, {{{1.0, 1.0}}, 101.0, 2.1, {}}).fits);
  EXPECT_FALSE(suitability(drive, {{{1.0, 1.0}}, 99.0, 2.0, {}}).fits);
}

// With the ratio n: 5 n rad/s... torque n min(20, 0.5 (50 - 0.5 n 5)/0.5) Nm at 5 rad/s, greatest
// at the corner, 0.5 n 5 = 30 V: n = 12, 240 Nm; ratios go in steps of 2 %.
TEST(Shortlist, TakesTheBestRatio) {
  const Suitability found =
      suitability(round_actuator(), {{{200.0, 5.0}}, {}, {}, Wanted::Ratios{4.0, 40.0}});
  EXPECT_NEAR(found.ratio, 12.0, 0.02 * 12.0);
  EXPECT_NEAR(*found.margin_share, 240.0 / 200.0 - 1.0, 0.03);
}

}  // namespace
}  // namespace torquewright::actuator
