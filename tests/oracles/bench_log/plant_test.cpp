// SPDX-License-Identifier: Apache-2.0
// The simulation against closed forms.
#include "tests/oracles/bench_log/plant.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace torquewright::oracles {
namespace {

Machine free_machine() {
  Machine machine;
  machine.ratio = 8.0;
  machine.torque_constant_Nm_A = 0.1;
  machine.load.type = Load::Type::kFree;
  machine.load.inertia_kg_m2 = 0.2;
  return machine;
}

Machine dynamometer_machine() {
  Machine machine = free_machine();
  machine.load = {};
  return machine;
}

RunPlan coast(double seconds, double speed_rad_s, double start_rad = 0.0) {
  RunPlan plan;
  plan.current_A = constant(knot_count(seconds), 0.0);
  plan.start_rad = start_rad;
  plan.start_rad_s = speed_rad_s;
  return plan;
}

RunPlan imposed(double seconds, double speed_rad_s, double current_A) {
  RunPlan plan;
  plan.speed_rad_s = constant(knot_count(seconds), speed_rad_s);
  plan.current_A = constant(knot_count(seconds), current_A);
  return plan;
}

TEST(SpinDown, FollowsItsClosedFormAndStopsForGood) {
  // J w' = -c - b w: w = (w0 + c/b) exp(-b t / J) - c/b until it is 0.
  Machine machine = free_machine();
  Friction& law = machine.friction;
  law.coulomb_positive_Nm = law.coulomb_negative_Nm = 0.5;
  law.viscous_positive_Nm_s_rad = law.viscous_negative_Nm_s_rad = 0.1;
  const double inertia = machine.load.inertia_kg_m2 + machine.motor_inertia_kg_m2();
  const Trace trace = simulate(machine, coast(4.0, 5.0));
  const double stop_s = inertia / 0.1 * std::log(1.0 + 5.0 * 0.1 / 0.5);
  // Second order: (h b / J)² / 24 of the speed per time constant.
  constexpr double kTolerance = 1e-7;
  for (std::size_t k = 0; k < trace.speed_rad_s.size(); ++k) {
    const double t = kTick_s * static_cast<double>(k);
    const double speed = t < stop_s ? 10.0 * std::exp(-0.1 * t / inertia) - 5.0 : 0.0;
    ASSERT_NEAR(trace.speed_rad_s[k], speed, kTolerance) << t;
    if (t > stop_s + kTick_s) {
      ASSERT_EQ(trace.speed_rad_s[k], 0.0) << t;
    }
  }
  const double way =
      10.0 * inertia / 0.1 * (1.0 - std::exp(-0.1 * stop_s / inertia)) - 5.0 * stop_s;
  EXPECT_NEAR(trace.position_rad.back(), way, 1e-6);
}

TEST(SpinDown, OfQuadraticDragIsAHyperbola) {
  // J w' = -d w²: w = w0 / (1 + w0 d t / J).
  Machine machine = free_machine();
  machine.friction.drag_Nm_s2_rad2 = 0.05;
  const double inertia = machine.load.inertia_kg_m2 + machine.motor_inertia_kg_m2();
  const Trace trace = simulate(machine, coast(2.0, 4.0));
  EXPECT_NEAR(trace.speed_rad_s.back(), 4.0 / (1.0 + 4.0 * 0.05 * 2.0 / inertia), 1e-6);
}

TEST(Pendulum, SwingsWithThePeriodOfItsWholeInertia) {
  Machine machine = free_machine();
  machine.load.type = Load::Type::kPendulum;
  machine.load.gravity_Nm = 6.0;
  const double inertia = machine.load.inertia_kg_m2 + machine.motor_inertia_kg_m2();
  constexpr double kSwing = 0.01;  // The period grows by swing²/16: 6e-6.
  const Trace trace = simulate(machine, coast(10.0, 0.0, kSwing));
  const double rate = std::sqrt(6.0 / inertia);
  for (std::size_t k = 0; k < trace.position_rad.size(); k += 100) {
    const double t = kTick_s * static_cast<double>(k);
    ASSERT_NEAR(trace.position_rad[k], kSwing * std::cos(rate * t),
                kSwing * (kSwing * kSwing / 16.0 * rate * t + 1e-4));
  }
}

TEST(Lag, AnswersARampOfOneTickAsAFirstOrderLagDoes) {
  Machine machine = dynamometer_machine();
  machine.lag_s = 0.02;
  RunPlan plan = imposed(0.3, 1.0, 10.0);
  plan.current_A[0] = 0.0;
  const Trace trace = simulate(machine, plan, 50);
  // After the ramp of length h: 1 - (T/h)(exp(h/T) - 1) exp(-t/T).
  const double ramp = 0.02 / kTick_s * std::expm1(kTick_s / 0.02);
  for (std::size_t k = 1; k < trace.torque_Nm.size(); ++k) {
    const double t = kTick_s * static_cast<double>(k);
    ASSERT_NEAR(trace.torque_Nm[k], 8.0 * (1.0 - ramp * std::exp(-t / 0.02)), 1e-5);
  }
}

TEST(Twist, IsHalfTheGapAndTheSpringsShare) {
  Machine machine = dynamometer_machine();
  machine.gap_rad = 0.02;
  machine.stiffness_Nm_rad = 1000.0;
  machine.damping_Nm_s_rad = 5.0;
  for (const double current : {10.0, -10.0}) {
    const Trace trace = simulate(machine, imposed(1.0, 0.5, current));
    const double twist = trace.motor_position_rad.back() / 8.0 - trace.position_rad.back();
    EXPECT_NEAR(twist, std::copysign(0.01 + 8.0 / 1000.0, current), 1e-6);
    EXPECT_NEAR(trace.torque_Nm.back(), 0.8 * current, 1e-3);
  }
  machine.gap_rad = 0.0;
  const Trace trace = simulate(machine, imposed(1.0, 0.5, 10.0));
  EXPECT_NEAR(trace.motor_position_rad.back() / 8.0 - trace.position_rad.back(), 0.008, 1e-6);
}

TEST(Twist, StaysInsideAFreeGap) {
  Machine machine = dynamometer_machine();
  machine.gap_rad = 0.05;
  RunPlan plan = imposed(0.2, 0.0, 0.0);
  const Trace trace = simulate(machine, plan);
  EXPECT_EQ(trace.torque_Nm.back(), 0.0);
}

TEST(Heat, FollowsTheTwoExponentialsOfTwoNodes) {
  // C x' = -K x + p: eigenvalues of the 2x2 matrix by hand, constant loss.
  Machine machine = dynamometer_machine();
  machine.resistance_1_K = 0.0;
  machine.winding_J_K = 20.0;
  machine.case_J_K = 90.0;
  machine.winding_to_case_K_W = 0.6;
  machine.case_to_ambient_K_W = 1.1;
  const double loss_W = 0.3 * 15.0 * 15.0;
  const double g1 = 1.0 / 0.6;
  const double g2 = 1.0 / 1.1;
  const double a = g1 / 20.0, b = g1 / 90.0, c = (g1 + g2) / 90.0;
  const double half = 0.5 * (a + c);
  const double root = std::sqrt(half * half - (a * c - a * b));
  const double r1 = half + root, r2 = half - root;
  const double end_winding = loss_W * (0.6 + 1.1);
  // x_w = end + A exp(-r1 t) + B exp(-r2 t), x_w(0) = 0, x_w'(0) = loss / C_w.
  const double A = (end_winding * r2 - loss_W / 20.0) / (r1 - r2);
  const double B = -end_winding - A;
  const Trace trace = simulate(machine, imposed(15.0, 1.0, 15.0));
  for (std::size_t k = 0; k < trace.winding_K.size(); k += 500) {
    const double t = kTick_s * static_cast<double>(k);
    const double rise = end_winding + A * std::exp(-r1 * t) + B * std::exp(-r2 * t);
    // Euler at 1 ms: half a tick of the rate, 3.4 K/s.
    ASSERT_NEAR(trace.winding_K[k] - 298.15, rise, 2e-3) << t;
  }
}

TEST(PreslidingFriction, StartsAsASpringAndEndsAsCoulomb) {
  Machine machine = dynamometer_machine();
  machine.friction.coulomb_positive_Nm = machine.friction.coulomb_negative_Nm = 0.5;
  machine.friction.presliding_Nm_rad = 10.0;
  RunPlan plan = imposed(4.0, 0.5, 0.0);
  const Trace trace = simulate(machine, plan);
  for (std::size_t k = 10; k < trace.torque_Nm.size(); k += 100) {
    const double x = trace.position_rad[k];
    ASSERT_NEAR(trace.torque_Nm[k], -0.5 * -std::expm1(-x / 0.05), 1e-9);
  }
}

TEST(ImposedMotion, HasASpeedThatIsItsPositionsSlope) {
  Chance chance(5);
  const ImposedMotion motion(scaled(multisine(chance, 2000, 0.5, 5.0, 5), 4.0), 0.3);
  for (const std::size_t knot : {0U, 7U, 900U, 1998U}) {
    const auto before = motion.at(knot, 0.4);
    const auto middle = motion.at(knot, 0.5);
    const auto after = motion.at(knot, 0.6);
    // Central difference over h = 0.2 ms: w'' h²/24 with w'' up to 4 (2 pi 5 Hz)².
    EXPECT_NEAR((after.position_rad - before.position_rad) / (0.2 * kTick_s), middle.speed_rad_s,
                7e-6);
    EXPECT_NEAR((after.speed_rad_s - before.speed_rad_s) / (0.2 * kTick_s),
                middle.acceleration_rad_s2, 1e-2);
    EXPECT_NEAR(motion.at(knot, 1.0 - 1e-12).position_rad, motion.at(knot + 1, 0.0).position_rad,
                1e-12);
  }
}

TEST(Voltage, DrivesTheNoLoadSpeed) {
  // Steady: V = R i + Ke N w with N Kt i = c, so w = (V - R c / (N Kt)) / (N Ke).
  Machine machine = free_machine();
  machine.friction.coulomb_positive_Nm = machine.friction.coulomb_negative_Nm = 0.4;
  machine.resistance_1_K = 0.0;
  machine.dead_time_V = 0.5;
  RunPlan plan;
  plan.voltage_V = constant(knot_count(4.0), 6.0);
  const Trace trace = simulate(machine, plan);
  EXPECT_NEAR(trace.speed_rad_s.back(), (6.0 - 0.5 - 0.3 * 0.4 / 0.8) / 0.8, 1e-6);
  EXPECT_NEAR(trace.current_A.back(), 0.5, 1e-6);
}

}  // namespace
}  // namespace torquewright::oracles
