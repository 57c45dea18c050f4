// SPDX-License-Identifier: Apache-2.0
// Oracle: the quasi-static line in closed form (example_actuator.hpp): at the rotor 20 Nm to 60
// rad/s, then 20 (100 - w) / 40; friction is taken off it, each way its own.
#include "actuator/mor/region_summary.hpp"

#include <gtest/gtest.h>

#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

TEST(RegionSummary, NamesWhatEndsTheTorqueAndWhere) {
  const Region region(round_actuator(), {});
  for (const double direction : {1.0, -1.0}) {
    const auto stretches = limited_stretches(region, direction);
    ASSERT_EQ(stretches.size(), 2u);
    EXPECT_EQ(stretches[0].limiter, Limiter::kCurrent);
    EXPECT_EQ(stretches[0].from_rad_s, 0.0);
    EXPECT_NEAR(stretches[0].to_rad_s, 6.0, 1e-6);
    EXPECT_NEAR(stretches[0].last_torque_Nm, 200.0, 1e-4);
    EXPECT_EQ(stretches[1].limiter, Limiter::kVoltage);
    EXPECT_EQ(stretches[1].from_rad_s, stretches[0].to_rad_s);
    EXPECT_NEAR(stretches[1].to_rad_s, 10.0, 1e-6);
    EXPECT_NEAR(stretches[1].last_torque_Nm, 0.0, 1e-4);
  }
}

// 30 Nm forward and 10 Nm backward at the joint: the line 50 (10 - w) meets them at 9.4 and 9.8.
TEST(RegionSummary, TellsTheWaysApart) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("asymmetric_friction", {30.0, 10.0, 0.0, 0.0}));
  const Region region(actuator, {});
  const DrivingFigures forward = driving_figures(region, 1.0);
  const DrivingFigures backward = driving_figures(region, -1.0);
  EXPECT_NEAR(forward.stall_torque_Nm, 170.0, 1e-9);
  EXPECT_NEAR(backward.stall_torque_Nm, 190.0, 1e-9);
  EXPECT_NEAR(forward.no_load_speed_rad_s, 9.4, 1e-6);
  EXPECT_NEAR(backward.no_load_speed_rad_s, 9.8, 1e-6);
}

// Short of current for the voltage to matter: one stretch, to the end.
TEST(RegionSummary, HasOneStretchWhereOneThingLimits) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("coulomb_friction", {250.0}));
  EXPECT_TRUE(limited_stretches(Region(actuator, {})).empty());
  EXPECT_EQ(driving_figures(Region(actuator, {})).greatest_power_W, 0.0);
}

}  // namespace
}  // namespace torquewright::actuator
