// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/joint_region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "actuator/region/left_out.hpp"
#include "actuator/region/torque_at.hpp"
#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

/// Ratio 10, 20 Nm at the rotor: 200 Nm before losses.
Actuator lossy_actuator() {
  Actuator actuator = round_actuator();
  actuator.transmission.forward_efficiency = 0.9;
  actuator.transmission.backward_efficiency = 0.8;
  actuator.effects.push_back(effect("coulomb_friction", {6.0}));
  actuator.effects.push_back(effect("load_dependent_friction", {0.25, 0.5}));
  return actuator;
}

// Oracle: the contract's order of losses. Driving: tau = eta_f/(1 + k_d) (N tau_m - drag). Back-
// driven: |tau| = (N |tau_m| + drag)/(eta_b (1 - k_b)).
TEST(JointRange, TakesLossesInTheContractsOrder) {
  const Region region(lossy_actuator(), {});
  const JointRange forward = region.at(1.0);
  EXPECT_NEAR(forward.greatest.torque_Nm, 0.9 / 1.25 * (200.0 - 6.0), 1e-10);
  EXPECT_NEAR(forward.least.torque_Nm, -(200.0 + 6.0) / (0.8 * 0.5), 1e-10);
  const JointRange backward = region.at(-1.0);
  EXPECT_NEAR(backward.least.torque_Nm, -0.9 / 1.25 * (200.0 - 6.0), 1e-10);
  EXPECT_NEAR(backward.greatest.torque_Nm, (200.0 + 6.0) / (0.8 * 0.5), 1e-10);
}

TEST(JointRange, AtRestIsTheUnionOfBothDirections) {
  const Region region(lossy_actuator(), {});
  const JointRange rest = region.at(0.0);
  EXPECT_NEAR(rest.greatest.torque_Nm, 206.0 / 0.4, 1e-10);
  EXPECT_NEAR(rest.least.torque_Nm, -206.0 / 0.4, 1e-10);
  EXPECT_LT(region.at(0.0, 1.0).greatest.torque_Nm, rest.greatest.torque_Nm);
}

// Beyond no-load speed friction brakes although the motor cannot drive: x = N T - drag < 0.
TEST(JointRange, LosesItsNoLoadSpeedToDrag) {
  const Region region(lossy_actuator(), {});
  // N K (V - K w)/R = 6 at w = (50 - 0.6)/0.5... at the rotor: T = 0.6 Nm, i = 1.2 A.
  const double end_rad_s = (50.0 - 1.2 * 0.5) / 0.5 / 10.0;
  EXPECT_NEAR(region.at(end_rad_s).greatest.torque_Nm, 0.0, 1e-9);
  EXPECT_GT(region.at(end_rad_s - 0.01).greatest.torque_Nm, 0.0);
  EXPECT_LT(region.at(end_rad_s + 0.01).greatest.torque_Nm, 0.0);
}

TEST(JointRange, OfANegativeRatioIsTurnedRound) {
  Actuator actuator = lossy_actuator();
  const Region straight(actuator, {});
  actuator.transmission.ratio = -10.0;
  const Region reversed(actuator, {});
  for (const double w : {-9.0, -1.0, 1.0, 9.0, 12.0}) {
    EXPECT_NEAR(straight.at(w).greatest.torque_Nm, reversed.at(w).greatest.torque_Nm, 1e-9);
    EXPECT_NEAR(straight.at(w).greatest.current_A, -reversed.at(w).greatest.current_A, 1e-9);
  }
}

TEST(JointRange, StopsAtTheGearsTorqueAndSaysTheCurrent) {
  Actuator actuator = lossy_actuator();
  actuator.transmission.peak_torque_Nm = 100.0;
  const JointRange range = Region(actuator, {}).at(1.0);
  EXPECT_EQ(range.greatest.limiter, Limiter::kGear);
  EXPECT_EQ(range.greatest.torque_Nm, 100.0);
  // Oracle: the losses inverted by hand: N tau_m = 100 * 1.25/0.9 + 6.
  EXPECT_NEAR(range.greatest.current_A, (100.0 * 1.25 / 0.9 + 6.0) / 10.0 / 0.5, 1e-9);
  EXPECT_EQ(range.least.torque_Nm, -100.0);
}

// Oracle: one motor behind two ratios (reference 2.5, M107): speed times ratio and torque over
// ratio are the motor's own.
TEST(JointRange, ScalesWithTheRatio) {
  Actuator actuator = round_actuator();
  const Region ten(actuator, {});
  actuator.transmission.ratio = 16.0;
  const Region sixteen(actuator, {});
  for (const double motor_rad_s : {-130.0, -80.0, 0.0, 40.0, 90.0, 120.0}) {
    EXPECT_NEAR(ten.at(motor_rad_s / 10.0).greatest.torque_Nm / 10.0,
                sixteen.at(motor_rad_s / 16.0).greatest.torque_Nm / 16.0, 1e-12);
  }
}

// The motor's side is the rotor: before any friction, at the rotor's speed.
TEST(JointRange, OnTheMotorsSideHasNoFriction) {
  const Actuator actuator = lossy_actuator();
  const Region motor(actuator, {}, Side::kMotor);
  EXPECT_NEAR(motor.at(10.0).greatest.torque_Nm, 20.0, 1e-12);
  EXPECT_NEAR(motor.greatest_speed_rad_s(), 140.0, 1e-9);
}

// Cogging and ripple count at their worst angle: both bounds move inward.
TEST(JointRange, CountsPeriodicEffectsAtTheirWorstAngle) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(harmonics("cogging_torque", {{12.0, 3.0, 0.4}}));
  actuator.effects.push_back(harmonics("gear_ripple", {{1.0, 0.05, 0.0}}, true));
  const JointRange range = Region(actuator, {}).at(1.0);
  EXPECT_NEAR(range.greatest.torque_Nm, (200.0 - 3.0) * 0.95, 1e-10);
  EXPECT_NEAR(range.least.torque_Nm, -(200.0 - 3.0) * 0.95, 1e-10);
}

// Oracle: extremes by hand. cos x + cos 2x runs from -9/8 (at cos x = -1/4) to 2 (at 0): two
// hundredths of the load take 9/8 of that from the greatest torque and from the least torque, whose
// sign turns the wave over, 9/8 too; a fixed wave takes 9/8 from one and 2 from the other. Both
// waves' ranges are granted curvature h^2/8 with h = 2 pi/128 (harmonics.cpp): (1 + 4) h^2/8 of the
// amplitude.
TEST(JointRange, TurnsAProportionalRippleOverWithTheLoad) {
  const double quarter_rad = 0.5 * std::numbers::pi;
  const double allowance = 5.0 * std::pow(2.0 * std::numbers::pi / 128.0, 2) / 8.0;
  for (const bool is_proportional : {true, false}) {
    const double amplitude = is_proportional ? 0.02 : 4.0;  // of 200 Nm, or in Nm
    Actuator actuator = round_actuator();
    actuator.effects.push_back(
        harmonics("gear_ripple", {{1.0, amplitude, quarter_rad}, {2.0, amplitude, quarter_rad}},
                  is_proportional));
    const JointRange range = Region(actuator, {}).at(1.0);
    EXPECT_NEAR(range.greatest.torque_Nm, 200.0 - 4.0 * 9.0 / 8.0, 4.0 * allowance);
    EXPECT_NEAR(range.least.torque_Nm, -200.0 + 4.0 * (is_proportional ? 9.0 / 8.0 : 2.0),
                4.0 * allowance);
  }
}

// Oracle: the law written out. The ripple of -30 Nm that come through the mesh, at 0.4 rad.
TEST(TorqueAt, TheRippleIsAShareOfTheLoadWithItsSign) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(harmonics("gear_ripple", {{3.0, 0.05, 0.2}}, true));
  Instant at;
  at.output_angle_rad = 0.4;
  at.load_torque_Nm = -30.0;
  EXPECT_NEAR(ripple_Nm(actuator, at), -30.0 * 0.05 * std::sin(1.4), 1e-15);
  at.current_A = 4.0;  // 10 * 0.5 * 4 = 20 Nm before the ripple
  EXPECT_NEAR(output_torque_Nm(actuator, at), 20.0 * (1.0 + 0.05 * std::sin(1.4)), 1e-14);
}

// Oracle: the law by hand. Without losses of the mesh a bound moves by the drag at its speed, most
// at the critical one; at rest, and far beyond, by next to nothing.
TEST(JointRange, LosesMostToEddyCurrentsAtTheCriticalSpeed) {
  Actuator actuator = round_actuator();
  const Region free(actuator, {});
  actuator.effects.push_back(effect("eddy_current_drag", {8.0, 2.0}));
  const Region braked(actuator, {});
  const auto lost_Nm = [&](double w) {
    return free.at(w).greatest.torque_Nm - braked.at(w).greatest.torque_Nm;
  };
  EXPECT_NEAR(lost_Nm(0.0), 0.0, 1e-12);
  for (const double w : {0.5, 2.0, 4.0, 9.0}) {
    EXPECT_NEAR(lost_Nm(w), 8.0 * 2.0 * (w / 2.0) / (1.0 + w * w / 4.0), 1e-10) << w;
    EXPECT_NEAR(lost_Nm(-w), -lost_Nm(w), 1e-10) << w;
  }
  EXPECT_FALSE(left_out(actuator, Part::kRegion).front().starts_with("eddy_current_drag"));
}

// A spring's torque has no bound over all angles: the region does without it, and says so.
TEST(LeftOut, ListsASpringByTheAngleAndLeavesTheRegionAlone) {
  Actuator actuator = round_actuator();
  const Region free(actuator, {});
  actuator.effects.push_back(effect("parallel_spring", {30.0, 0.4}));
  const Region sprung(actuator, {});
  EXPECT_EQ(sprung.at(3.0).greatest.torque_Nm, free.at(3.0).greatest.torque_Nm);
  EXPECT_EQ(left_out(actuator, Part::kRegion).front(),
            "parallel_spring: depends on the output's angle, which no region of torque over speed "
            "can hold");
}

TEST(LeftOut, ListsWhatARegionCannotHold) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("torque_lag", {0.01}));
  actuator.effects.push_back(effect("backlash", {0.01}));
  const std::vector<std::string> sentences = left_out(actuator, Part::kRegion);
  ASSERT_GE(sentences.size(), 2u);
  EXPECT_TRUE(sentences[0].starts_with("torque_lag"));
  EXPECT_TRUE(sentences[1].starts_with("backlash"));
}

}  // namespace
}  // namespace torquewright::actuator
