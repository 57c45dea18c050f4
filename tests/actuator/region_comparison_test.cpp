// SPDX-License-Identifier: Apache-2.0
// Oracles: the order of losses (docs/notation.md) in closed form on an actuator of round numbers.
#include "actuator/mor/region_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kComparedRounding = 1e-9;  // some hundred roundings of torques of 200 Nm

RegionComparison compared(const Actuator& from, const Actuator& to) {
  return compare(Region(from, {}), Region(to, {}));
}

TEST(RegionComparison, SeesNoDifferenceBetweenEquals) {
  const RegionComparison comparison = compared(round_actuator(), round_actuator());
  for (const QuadrantComparison& quadrant : comparison.quadrants) {
    EXPECT_EQ(quadrant.worst_loss.change_Nm, 0.0);
    EXPECT_EQ(quadrant.best_gain.change_Nm, 0.0);
  }
  EXPECT_NEAR(comparison.from.peak_torque_Nm, 200.0, kComparedRounding);  // 0.5 Nm/A 40 A 10
  EXPECT_NEAR(comparison.from.stall_torque_Nm, 200.0, kComparedRounding);
  EXPECT_NEAR(comparison.from.no_load_speed_rad_s, 10.0, 1e-4);  // 100 rad/s over 10
}

// Driving, 200 / 1.25 are left; back-driven the gear holds 200 / 0.8.
TEST(RegionComparison, FindsWhatLoadFrictionTakesAndHolds) {
  Actuator refined = round_actuator();
  refined.effects.push_back(effect("load_dependent_friction", {0.25, 0.2}));
  const RegionComparison comparison = compared(round_actuator(), refined);
  for (const std::size_t driving : {0u, 2u}) {
    EXPECT_NEAR(comparison.quadrants[driving].worst_loss.change_Nm, -40.0, kComparedRounding);
    EXPECT_EQ(comparison.quadrants[driving].best_gain.change_Nm, 0.0);
  }
  for (const std::size_t braking : {1u, 3u}) {
    EXPECT_NEAR(comparison.quadrants[braking].best_gain.change_Nm, 50.0, kComparedRounding);
    EXPECT_EQ(comparison.quadrants[braking].worst_loss.change_Nm, 0.0);
  }
}

// Ten volts more: the corner moves from 6 to 8 rad/s, no-load speed from 10 to 12. Between 8 and 10
// both lines have the slope of 50 Nm s/rad: 100 Nm are won there, and at 8 rad/s first.
TEST(RegionComparison, FindsWhereVoltageHelps) {
  Actuator faster = round_actuator();
  faster.drive.bus_voltage_V = 60.0;
  const RegionComparison comparison = compared(round_actuator(), faster);
  const TorqueChange& gain = comparison.quadrants[0].best_gain;
  EXPECT_NEAR(gain.change_Nm, 100.0, 1e-6);
  EXPECT_GE(gain.speed_rad_s, 8.0 - 1e-3);
  EXPECT_LE(gain.speed_rad_s, 10.0 + 1e-3);
  EXPECT_NEAR(comparison.to.no_load_speed_rad_s, 12.0, 1e-4);
  EXPECT_EQ(comparison.quadrants[0].worst_loss.change_Nm, 0.0);
}

// Oracle: the region's own end: past its overspeed of (50 + 20) V / 0.5 the slow one is empty.
TEST(RegionComparison, DoesNotCountSpeedsAtWhichOneRegionIsEmpty) {
  Actuator slow = round_actuator();
  Actuator fast = round_actuator();
  slow.drive.bus_voltage_V = 50.0;
  fast.drive.bus_voltage_V = 200.0;
  const RegionComparison comparison = compared(slow, fast);
  const double end_rad_s = Region(slow, {}).greatest_speed_rad_s();
  ASSERT_TRUE(comparison.one_sided_rad_s);
  EXPECT_GT(std::abs(*comparison.one_sided_rad_s), end_rad_s);
  for (const QuadrantComparison& quadrant : comparison.quadrants) {
    EXPECT_LE(std::abs(quadrant.best_gain.speed_rad_s), end_rad_s);
  }
  EXPECT_FALSE(compared(slow, slow).one_sided_rad_s);
}

}  // namespace
}  // namespace torquewright::actuator
