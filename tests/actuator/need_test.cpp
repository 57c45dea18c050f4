// SPDX-License-Identifier: Apache-2.0
#include "actuator/mor/need.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

// Oracle: the quasi-static line in closed form. 150 Nm at 9 rad/s: 15 Nm and 90 rad/s at the rotor,
// 30 A; there is 0.5 (50 - 45)/0.5 = 5 Nm. V = R i + K w = 15 + 45 = 60 V would do.
TEST(Need, NamesTheLeastVoltageThatWouldDo) {
  const NeedAnswer result = answer_need(round_actuator(), {}, {150.0, 9.0});
  EXPECT_FALSE(result.is_reached);
  EXPECT_NEAR(result.margin_Nm, 50.0 - 150.0, 1e-9);
  EXPECT_EQ(result.limiter, Limiter::kVoltage);
  ASSERT_TRUE(result.least_bus_voltage_V);
  EXPECT_NEAR(*result.least_bus_voltage_V, 60.0, 1e-6);
  EXPECT_FALSE(result.least_current_A);  // no current helps against the voltage
}

// Kt N i: what is asked to the last decimal of the peak is reached, however its product is rounded.
TEST(Need, IsReachedAtThePeakItself) {
  Actuator actuator = round_actuator();
  actuator.motor.torque_constant_Nm_A = 0.07;
  for (int tenths = 31; tenths <= 99; tenths += 4) {
    actuator.transmission.ratio = tenths / 10.0;
    for (int current_A = 1; current_A <= 40; current_A += 3) {
      actuator.drive.peak_current_A = current_A;
      const double torque_Nm = 7 * tenths * current_A / 1000.0;
      EXPECT_TRUE(answer_need(actuator, {}, {torque_Nm, 0.1}).is_reached) << torque_Nm;
      EXPECT_FALSE(answer_need(actuator, {}, {1.00001 * torque_Nm, 0.1}).is_reached) << torque_Nm;
    }
  }
}

// 300 Nm at 1 rad/s: 30 Nm is 60 A at the rotor; R i + K w = 30 + 5 <= 50 V.
TEST(Need, NamesTheLeastCurrentThatWouldDo) {
  const NeedAnswer result = answer_need(round_actuator(), {}, {300.0, 1.0});
  EXPECT_EQ(result.limiter, Limiter::kCurrent);
  ASSERT_TRUE(result.least_current_A);
  EXPECT_NEAR(*result.least_current_A, 60.0, 1e-6);
  // A ratio of 15 gives 300 Nm at 40 A and 15 rad/s at the rotor.
  ASSERT_TRUE(result.nearest_ratio);
  EXPECT_NEAR(*result.nearest_ratio, 15.0, 1e-6);
}

// Oracle: the same 60 A whichever rating is asked: a continuous current above the drive's peak of
// 40 A needs a drive with that peak too, and the need counts it. At half the need 30 A do, which
// the peak already allows.
TEST(Need, RaisesThePeakWhereTheContinuousCurrentWouldPassIt) {
  Actuator actuator = round_actuator();
  actuator.drive.continuous_current_A = 20.0;
  OperatingConditions continuous;
  continuous.rating = Rating::kContinuous;
  for (const double torque_Nm : {300.0, 150.0}) {
    const NeedAnswer result = answer_need(actuator, continuous, {torque_Nm, 1.0});
    EXPECT_EQ(result.limiter, Limiter::kCurrent);
    ASSERT_TRUE(result.least_current_A);
    EXPECT_NEAR(*result.least_current_A, torque_Nm / 5.0, 1e-6);
  }
}

// 150 Nm at 9 rad/s by ratio: 0.5 i N = 150 and 0.5 i + 4.5 N = 50 have no common solution with
// i <= 40: N >= 7.5, and (50 - 4.5 N) N >= 150 holds for 5 <= N <= 6.1 only.
TEST(Need, SaysWhereNoRatioWouldDo) {
  EXPECT_FALSE(answer_need(round_actuator(), {}, {150.0, 9.0}).nearest_ratio);
}

// Oracle: closed form. The gears carry 120 Nm of the 200 Nm that the motor makes; 150 Nm need gears
// for 150, and no other voltage or current helps. 300 Nm are beyond the motor, too.
TEST(Need, NamesTheStrengthOfGearsThatLimit) {
  Actuator actuator = round_actuator();
  actuator.transmission.peak_torque_Nm = 120.0;
  const NeedAnswer result = answer_need(actuator, {}, {150.0, 1.0});
  EXPECT_EQ(result.limiter, Limiter::kGear);
  ASSERT_TRUE(result.least_gear_Nm);
  EXPECT_NEAR(*result.least_gear_Nm, 150.0, 1e-6);
  EXPECT_FALSE(result.least_bus_voltage_V);
  EXPECT_FALSE(result.least_current_A);
  EXPECT_FALSE(answer_need(actuator, {}, {300.0, 1.0}).least_gear_Nm);
}

// Oracle: closed form of the line: 50 Nm of braking are -10 A, R i + K w = -5 + 60 = 55 V, less
// some 10 mV that they raise over the battery's 1 mohm. Above 75 V the pack takes nothing back, so
// that ten times the voltage does not do.
TEST(Need, FindsAVoltageThoughTenTimesAsMuchIsTooMuch) {
  Actuator actuator = round_actuator();
  actuator.battery.emplace();
  actuator.battery->series_cells = 1;
  actuator.battery->parallel_cells = 1;
  actuator.battery->cell_open_circuit = {{1.0, actuator.drive.bus_voltage_V}};
  actuator.battery->cell_resistance_ohm = 1e-3;
  actuator.battery->maximum_voltage_V = 75.0;
  actuator.drive.regeneration = true;
  const NeedAnswer result = answer_need(actuator, {}, {-50.0, 12.0});
  ASSERT_TRUE(result.least_bus_voltage_V);
  EXPECT_NEAR(*result.least_bus_voltage_V, 55.0 - 0.01, 1e-3);
  OperatingConditions tenfold;
  tenfold.bus_voltage_V = 10.0 * actuator.drive.bus_voltage_V;
  EXPECT_FALSE(answer_need(actuator, tenfold, {-50.0, 12.0}).is_reached);
}

// What was not looked for is not "none": the answer says that it was told to stop.
TEST(Need, EndsWhenItIsTold) {
  int asked = 0;
  const auto soon = [&asked] { return ++asked > 3; };
  const NeedAnswer result = answer_need(round_actuator(), {}, {150.0, 9.0}, soon);
  EXPECT_TRUE(result.is_ended);
  EXPECT_FALSE(result.least_bus_voltage_V);
  EXPECT_LT(asked, 20);
  EXPECT_FALSE(answer_need(round_actuator(), {}, {150.0, 9.0}).is_ended);
}

// Oracle: the region, which also knows where it ends.
TEST(Need, AsksForTheRangeThatTheRegionHas) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("coulomb_friction", {5.0}));
  const Region region(actuator, {});
  for (const double speed_rad_s : {-9.0, 0.0, 3.0, 20.0}) {
    const JointRange one = region.at(speed_rad_s);
    const JointRange other = range_at(actuator, {}, speed_rad_s);
    ASSERT_EQ(one.is_empty, other.is_empty);
    EXPECT_EQ(one.least.torque_Nm, other.least.torque_Nm);
    EXPECT_EQ(one.greatest.torque_Nm, other.greatest.torque_Nm);
  }
}

TEST(Need, GivesTheMarginWhereItIsReached) {
  const NeedAnswer result = answer_need(round_actuator(), {}, {-150.0, 9.0});
  EXPECT_TRUE(result.is_reached);
  EXPECT_NEAR(result.margin_Nm, 50.0, 1e-9);
  EXPECT_EQ(result.limiter, Limiter::kCurrent);
}

// Oracle: a lossless motor's stall torque N K i, no-load speed V/(K N), and power: 60 rad/s at 20
// Nm is 1200 W, beyond the corner T w = (50 - 0.5 w) w falls from w = 50 on; so the corner has it.
TEST(RatioSweep, GivesTheClosedFormsOfTheLine) {
  const auto rows = ratio_sweep(round_actuator(), {}, 5.0, 20.0, 3, Need{100.0, 5.0});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_NEAR(rows[1].ratio, 10.0, 1e-12);
  for (const RatioRow& row : rows) {
    EXPECT_NEAR(row.driving.stall_torque_Nm, 20.0 * row.ratio, 1e-9);
    EXPECT_NEAR(row.driving.no_load_speed_rad_s, 100.0 / row.ratio, 1e-6);
    EXPECT_NEAR(row.driving.greatest_power_W, 1200.0, 1e-2);
  }
  EXPECT_NEAR(*rows[1].margin_Nm, 100.0, 1e-9);
}

// Evenly spaced in their logarithm: 5, 10, 20; one alone is the lowest.
TEST(RatioSweep, RunsFromTheLowestRatioToTheHighest) {
  Actuator actuator = round_actuator();
  EXPECT_EQ(ratio_sweep(actuator, {}, 5.0, 20.0, 1, std::nullopt).front().ratio, 5.0);
  actuator.transmission.ratio = -10.0;  // the present sign stays
  const auto rows = ratio_sweep(actuator, {}, 5.0, 20.0, 3, std::nullopt);
  EXPECT_NEAR(rows[0].ratio, -5.0, 1e-15);
  EXPECT_NEAR(rows[1].ratio, -10.0, 1e-14);
  EXPECT_EQ(rows[2].ratio, -20.0);
  EXPECT_FALSE(rows[0].margin_Nm);
}

// Oracle: 250 Nm of dry friction at the joint against 20 Nm of the motor, at ratios up to 10:
// nothing turns, and what does not turn drives with no torque, at no speed, with no power.
TEST(RatioSweep, SaysThatFrictionHoldsTheMotor) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("coulomb_friction", {250.0}));
  for (const RatioRow& row : ratio_sweep(actuator, {}, 5.0, 10.0, 2, std::nullopt)) {
    EXPECT_EQ(row.driving.stall_torque_Nm, 0.0);
    EXPECT_EQ(row.driving.no_load_speed_rad_s, 0.0);
    EXPECT_EQ(row.driving.greatest_power_W, 0.0);
  }
}

}  // namespace
}  // namespace torquewright::actuator
