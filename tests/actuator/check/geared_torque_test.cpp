// SPDX-License-Identifier: Apache-2.0
// Oracle: Newton's law of a rotor of 0.5 kg m^2 at the joint (10:1), by hand: of 20 rad/s^2 it
// takes 10 Nm there, 1 Nm of the motor, 10 A; whatever passes the teeth is the load's alone.
#include "actuator/drive_check/geared_torque.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

#include "actuator/drive_check/demand.hpp"
#include "tests/actuator/check/checked_joint.hpp"

namespace torquewright::actuator {
namespace {

using check_test::Checked;
using check_test::motion;

Actuator heavy_rotor() {
  Actuator actuator = test::simple_actuator();
  actuator.motor.rotor_inertia_kg_m2 = 5e-3;
  return actuator;
}

CheckReport checked(const Actuator& actuator, check_test::Function velocity,
                    check_test::Function torque, InertiaConvention inertia) {
  Checked check(actuator);
  check.request().inertia = inertia;
  return check.report(motion(10, nullptr, velocity, torque));
}

double speeding_up(double t) { return 20.0 * t; }
double slowing_down(double t) { return 30.0 - 20.0 * t; }
double nothing(double) { return 0.0; }
double push_8(double) { return 8.0; }
double pull_8(double) { return -8.0; }
double pull_18(double) { return -18.0; }
double rotor_10(double) { return 10.0; }
double steady(double) { return 10.0; }

TEST(GearedTorque, OfTheRotorLoadsNoTeeth) {
  Actuator actuator = heavy_rotor();
  actuator.transmission.peak_torque_Nm = 5.0;
  using enum InertiaConvention;
  EXPECT_EQ(checked(actuator, speeding_up, nothing, kExcluded).verdict, Verdict::kPass);
  EXPECT_EQ(checked(actuator, speeding_up, rotor_10, kIncluded).verdict, Verdict::kPass);
  // The rotor's 10 Nm make the motor's 2 of them, and the teeth bear 8 all the same.
  const CheckReport report = checked(actuator, speeding_up, pull_8, kExcluded);
  const WorstSample& worst = report.drives[0].interpretation.worst;
  EXPECT_EQ(report.verdict, Verdict::kFail);
  EXPECT_EQ(worst.limiter, Limiter::kGear);
  EXPECT_NEAR(worst.torque_Nm, -8.0, 1e-9);
  EXPECT_NEAR(*worst.limit_Nm, -5.0, 0.0);
  EXPECT_NEAR(worst.excess_Nm, 3.0, 1e-9);
  actuator.transmission.peak_torque_Nm = 8.5;
  const CheckReport enough = checked(actuator, speeding_up, pull_8, kExcluded);
  EXPECT_EQ(enough.verdict, Verdict::kPass);
  EXPECT_NEAR(enough.drives[0].interpretation.margin_Nm, 0.5, 1e-9);
}

TEST(GearedTorque, OfTheRotorIsLostInNoMesh) {
  Actuator actuator = heavy_rotor();
  actuator.transmission.forward_efficiency = 0.8;
  actuator.transmission.backward_efficiency = 0.5;
  const auto current_A = [&](check_test::Function velocity, check_test::Function torque) {
    const CheckReport report = checked(actuator, velocity, torque, InertiaConvention::kExcluded);
    return report.drives[0].interpretation.peak_current_A;
  };
  EXPECT_NEAR(current_A(speeding_up, nothing), 10.0, 1e-9);
  EXPECT_NEAR(current_A(slowing_down, nothing), 10.0, 1e-9);
  EXPECT_NEAR(current_A(speeding_up, push_8), 8.0 / 0.8 + 10.0, 1e-9);
  EXPECT_NEAR(current_A(slowing_down, pull_8), 0.5 * 8.0 + 10.0, 1e-9);
  EXPECT_NEAR(current_A(slowing_down, push_8), 0.0, 1e-9);  // 8 / 0.8 - 10: the rotor pushes
  EXPECT_NEAR(current_A(steady, push_8), 10.0, 1e-9);
}

// Oracle: as above, at the instant at which it begins to move: 8 Nm behind the mesh, 10 Nm before.
TEST(GearedTorque, OfAJointThatBeginsToMoveIsThatOfOneThatMoves) {
  Actuator actuator = heavy_rotor();
  actuator.transmission.forward_efficiency = 0.8;
  actuator.transmission.backward_efficiency = 0.5;
  for (const double way : {1.0, -1.0}) {
    const GearedTorque asked = RotorBeforeMesh(actuator).of(0.0, way * 18.0, way * 20.0, 0.0);
    EXPECT_NEAR(asked.teeth_Nm, way * 8.0, 1e-12);
    const OperatingConditions conditions;
    const auto demand = demand_at(actuator, phase_model_at(actuator, conditions),
                                  winding_temperature_K(actuator, conditions), 0.0, asked.motor_Nm);
    ASSERT_TRUE(demand.has_value());
    EXPECT_NEAR(demand->current_A, 8.0 / 0.8 + 10.0, 1e-9);
  }
}

// Oracle: as above, at the instant at which it comes to rest: 8 Nm behind the mesh pull, which that
// halves, and the rotor's 10 Nm; as a little before.
TEST(GearedTorque, OfAJointThatComesToRestIsThatOfOneThatBrakes) {
  Actuator actuator = heavy_rotor();
  actuator.transmission.forward_efficiency = 0.8;
  actuator.transmission.backward_efficiency = 0.5;
  const OperatingConditions conditions;
  const auto current_A = [&](double speed_rad_s) {
    const GearedTorque asked = RotorBeforeMesh(actuator).of(speed_rad_s, -18.0, -20.0, 1e-3);
    return demand_at(actuator, phase_model_at(actuator, conditions),
                     winding_temperature_K(actuator, conditions), speed_rad_s, asked.motor_Nm)
        ->current_A;
  };
  EXPECT_NEAR(current_A(1e-9), 8.0 * 0.5 + 10.0, 1e-9);
  EXPECT_NEAR(current_A(0.0), 8.0 * 0.5 + 10.0, 1e-9);
}

// Braked to a standstill by 18 Nm, 14 A; a last velocity that differs from 0 by rounding is none.
TEST(GearedTorque, OfAStopIsJudgedAsItsBraking) {
  Actuator actuator = heavy_rotor();
  actuator.transmission.forward_efficiency = 0.8;
  actuator.transmission.backward_efficiency = 0.5;
  using enum InertiaConvention;
  const std::initializer_list<check_test::Function> stops{
      [](double t) { return 20.0 - 20.0 * t; },
      [](double t) { return t < 1.0 ? 20.0 - 20.0 * t : 1e-16; },
      [](double t) { return t < 1.0 ? 20.0 - 20.0 * t : -1e-16; }};
  for (const check_test::Function stop : stops) {
    actuator.drive.peak_current_A = 14.1;
    const CheckReport report = checked(actuator, stop, pull_18, kIncluded);
    EXPECT_EQ(report.verdict, Verdict::kPass) << stop(1.0);
    EXPECT_GT(report.drives[0].interpretation.speed_margin_rad_s.value_or(0.0), 0.1) << stop(1.0);
    actuator.drive.peak_current_A = 13.9;
    EXPECT_EQ(checked(actuator, stop, pull_18, kIncluded).verdict, Verdict::kFail) << stop(1.0);
  }
}

// A braking rotor asks for all that the motor has, although the gear would help it to hold a load.
TEST(GearedTorque, OfABrakingRotorIsTheMotorsAlone) {
  Actuator actuator = heavy_rotor();
  actuator.transmission.backward_efficiency = 0.5;
  using enum InertiaConvention;
  actuator.drive.peak_current_A = 10.1;
  EXPECT_EQ(checked(actuator, slowing_down, nothing, kExcluded).verdict, Verdict::kPass);
  actuator.drive.peak_current_A = 9.9;
  EXPECT_EQ(checked(actuator, slowing_down, nothing, kExcluded).verdict, Verdict::kFail);
}

// What locks itself is driven back by nothing; the rotor's torque counts at the joint as it is.
TEST(GearedTorque, OfASelfLockingGearIsFinite) {
  Actuator actuator = heavy_rotor();
  actuator.transmission.backward_efficiency = 0.0;
  actuator.transmission.peak_torque_Nm = 50.0;
  const GearedTorque asked = RotorBeforeMesh(actuator).of(5.0, -10.0, -20.0, 5.0);
  EXPECT_EQ(asked.motor_Nm, -10.0);
  EXPECT_EQ(asked.teeth_Nm, 0.0);
}

}  // namespace
}  // namespace torquewright::actuator
