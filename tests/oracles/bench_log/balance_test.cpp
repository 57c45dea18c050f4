// SPDX-License-Identifier: Apache-2.0
// The simulation against conservation laws, its own order, and the contract's order of losses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/oracles/bench_log/plant.hpp"

namespace torquewright::oracles {
namespace {

Machine pendulum_machine() {
  Machine machine;
  machine.ratio = 9.3;
  machine.torque_constant_Nm_A = 0.1;
  machine.peak_current_A = 30.0;
  machine.load.type = Load::Type::kPendulum;
  machine.load.inertia_kg_m2 = 0.25;
  machine.load.gravity_Nm = 8.0;
  return machine;
}

Machine lossy_machine() {
  Machine machine = pendulum_machine();
  Friction& law = machine.friction;
  law.coulomb_positive_Nm = 0.6;
  law.coulomb_negative_Nm = 0.4;
  law.viscous_positive_Nm_s_rad = law.viscous_negative_Nm_s_rad = 0.05;
  law.breakaway_excess_Nm = 0.3;
  law.stribeck_velocity_rad_s = 0.3;
  machine.forward_efficiency = 0.93;
  machine.backward_efficiency = 0.9;
  machine.driving_coefficient = 0.05;
  machine.backdriving_coefficient = 0.04;
  return machine;
}

RunPlan swing(double seconds) {
  RunPlan plan;
  Chance chance(3);
  plan.current_A = scaled(multisine(chance, knot_count(seconds), 0.2, 2.0, 5), 9.0);
  return plan;
}

double imbalance_J(const EnergyAccount& account) {
  return account.motor_J - account.stored_J - account.friction_J - account.gear_J;
}

TEST(Energy, PutInIsStoredOrLost) {
  EnergyAccount account;
  simulate(lossy_machine(), swing(10.0), 20, &account);
  EXPECT_GT(account.motor_J, 5.0);
  EXPECT_GT(account.friction_J, 1.0);
  EXPECT_GT(account.gear_J, 0.1);
  // Second order in the step of 0.05 ms; gravity's work is that of the middle of each step.
  EXPECT_NEAR(imbalance_J(account), 0.0, 1e-5 * account.motor_J);
}

TEST(Energy, IsKeptWithoutLosses) {
  RunPlan plan;
  plan.current_A = constant(knot_count(10.0), 0.0);
  plan.start_rad = 2.0;
  EnergyAccount account;
  const Trace trace = simulate(pendulum_machine(), plan, 10, &account);
  EXPECT_NEAR(account.stored_J, 0.0, 1e-5 * 8.0);
  EXPECT_GT(*std::max_element(trace.speed_rad_s.begin(), trace.speed_rad_s.end()), 3.0);
}

TEST(Energy, OfTwoInertiasFallsByTheSpringsDamperOnly) {
  Machine machine = pendulum_machine();
  machine.stiffness_Nm_rad = 400.0;
  RunPlan plan;
  plan.current_A = constant(knot_count(5.0), 0.0);
  plan.start_rad = 1.0;
  EnergyAccount account;
  simulate(machine, plan, 20, &account);
  // A kick between two halves of motion: the energy swings by (w h)² but does not drift.
  EXPECT_NEAR(account.stored_J, 0.0, 1e-3);
  machine.damping_Nm_s_rad = 2.0;
  simulate(machine, plan, 20, &account);
  EXPECT_LT(account.stored_J, 0.0);
}

double distance(const Trace& a, const Trace& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.position_rad.size(); ++k) {
    most = std::max(most, std::abs(a.position_rad[k] - b.position_rad[k]));
  }
  return most;
}

TEST(StepHalving, GainsAFactorOfFourWhereTheMotionIsSmooth) {
  Machine machine = pendulum_machine();
  machine.friction.viscous_positive_Nm_s_rad = machine.friction.viscous_negative_Nm_s_rad = 0.3;
  const RunPlan plan = swing(3.0);
  const Trace fine = simulate(machine, plan, 160);
  const double coarse = distance(simulate(machine, plan, 5), fine);
  const double halved = distance(simulate(machine, plan, 10), fine);
  EXPECT_NEAR(coarse / halved, 4.0, 0.3);
  EXPECT_LT(halved, 1e-5);  // A tenth of an encoder's count.
}

TEST(StepHalving, ConvergesThroughSticking) {
  const RunPlan plan = swing(5.0);
  const Machine machine = lossy_machine();
  const Trace fine = simulate(machine, plan, 160);
  const double coarse = distance(simulate(machine, plan, 10), fine);
  const double halved = distance(simulate(machine, plan, 40), fine);
  EXPECT_LT(halved, 0.5 * coarse);
  EXPECT_LT(coarse, 1e-4);  // An encoder's count.
}

// At rest, a load G is held while (contract, order of losses)
//   eta_f/(1+k_d) (N Kt i - drag) <= G  and  G <= (N Kt i + drag) / (eta_b (1 - k_b)).
RunPlan hold(const Machine& machine, double torque_Nm) {
  RunPlan plan;
  plan.start_rad = 1.0;
  plan.current_A =
      constant(knot_count(0.5), torque_Nm / (machine.ratio * machine.torque_constant_Nm_A));
  return plan;
}

TEST(Sticking, HoldsExactlyUpToBreakaway) {
  const Machine machine = lossy_machine();
  const double load = 8.0 * std::sin(1.0);
  const double up = load * 1.05 / 0.93 + 0.6 + 0.3;
  const double down = load * 0.9 * 0.96 - 0.4 - 0.3;
  for (const double held : {up - 1e-6, 0.5 * (up + down), down + 1e-6}) {
    const Trace trace = simulate(machine, hold(machine, held));
    EXPECT_EQ(trace.position_rad.back(), 1.0) << held;
    EXPECT_EQ(trace.torque_Nm.back(), load) << held;
  }
  EXPECT_GT(simulate(machine, hold(machine, up + 1e-3)).position_rad.back(), 1.0);
  EXPECT_LT(simulate(machine, hold(machine, down - 1e-3)).position_rad.back(), 1.0);
}

TEST(OrderOfLosses, IsTheContractsInAllQuadrants) {
  Machine machine = lossy_machine();
  machine.load = {};
  machine.friction = {};
  machine.friction.coulomb_positive_Nm = machine.friction.coulomb_negative_Nm = 0.5;
  for (const double speed : {2.0, -2.0}) {
    for (const double current : {10.0, -10.0}) {
      RunPlan plan;
      plan.speed_rad_s = constant(100, speed);
      plan.current_A = constant(100, current);
      const double motor = std::abs(9.3 * 0.1 * current);
      const double driving = 0.93 / 1.05 * (motor - 0.5);
      const double driven = (motor + 0.5) / (0.9 * 0.96);
      const double size = speed * current > 0.0 ? driving : driven;
      EXPECT_NEAR(simulate(machine, plan).torque_Nm.back(), std::copysign(size, current), 1e-12);
    }
  }
}

TEST(OrderOfLosses, IsBackDrivenWhereTheLoadPullsTheRotorAlong) {
  // A motor torque of 1 helps the fall, but the rotor takes more: y = 1 - Jm a < 0, so the gear
  // passes y / eta_b, and (J + Jm / eta_b) a = G + 1 / eta_b.
  Machine machine = pendulum_machine();
  machine.rotor_inertia_kg_m2 = 1e-3;
  machine.forward_efficiency = machine.backward_efficiency = 0.8;
  RunPlan plan = hold(machine, -1.0);
  plan.start_rad = 0.5 * 3.141592653589793;
  const double rotor = 9.3 * 9.3 * 1e-3;
  const double expected = (8.0 + 1.0 / 0.8) / (0.25 + rotor / 0.8);
  ASSERT_GT(rotor * expected, 1.0);
  // Over one tick gravity's lever changes by 1e-10.
  EXPECT_NEAR(simulate(machine, plan).speed_rad_s[1], -expected * kTick_s, 1e-8);
}

TEST(OrderOfLosses, HoldsAtRestOnADynamometerToo) {
  Machine machine;
  machine.ratio = 10.0;
  machine.friction.coulomb_positive_Nm = machine.friction.coulomb_negative_Nm = 0.5;
  RunPlan plan;
  plan.speed_rad_s = constant(100, 0.0);
  plan.current_A = constant(100, 5.0);
  const double torque = simulate(machine, plan).torque_Nm.back();
  EXPECT_GE(torque, 5.0 - 0.5);
  EXPECT_LE(torque, 5.0 + 0.5);
}

}  // namespace
}  // namespace torquewright::oracles
