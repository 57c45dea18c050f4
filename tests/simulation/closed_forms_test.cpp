// SPDX-License-Identifier: Apache-2.0
// Oracles: closed forms of single motions.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/simulation/simple_drive.hpp"

namespace torquewright::simulation {
namespace {

double nothing(double) { return 0.0; }

// J dw/dt = -b w - c: w = (w0 + c/b) exp(-b t/J) - c/b, at rest from t = J/b ln(1 + b w0/c) on.
TEST(Simulation, SpinsDownByCoulombAndViscousFriction) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("viscous_friction", {0.05}), effect("coulomb_friction", {0.2})};
  const double inertia = 0.02 + 0.01;
  const double start = 10.0;
  const double stop_s = inertia / 0.05 * std::log1p(0.05 * start / 0.2);
  const auto excited = excitation(1.5, 1e-3, nothing);
  const SimulatedRun spun = run(Load::kFree, actuator, excited, {0.0, start, {}, {}});
  const JointTrace& trace = spun.joints[0];
  // Midpoint rule: error of a step (h b/J)^3/6 w, 4 h^2 (b/J)^2 w in all, 1e-6; far below 1e-5.
  for (std::size_t i = 0; i < excited.time_s.size(); ++i) {
    const double t = excited.time_s[i];
    const double exact = t < stop_s ? (start + 4.0) * std::exp(-0.05 * t / inertia) - 4.0 : 0.0;
    EXPECT_NEAR(trace.speed_rad_s[i], exact, 1e-5) << t;
  }
  EXPECT_EQ(trace.speed_rad_s.back(), 0.0);
  EXPECT_EQ(trace.position_rad.back(), trace.position_rad[trace.position_rad.size() - 100]);
}

TEST(Simulation, ErrorFallsWithTheSquareOfTheStep) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("viscous_friction", {0.4})};
  const double exact = 10.0 * std::exp(-0.4 * 0.2 / 0.03);
  double error[2] = {};
  for (int halved = 0; halved < 2; ++halved) {
    const auto excited = excitation(0.2, 0.01, nothing);
    const SimulatedRun spun =
        run(Load::kFree, actuator, excited, {0.0, 10.0, {}, {}}, halved == 0 ? 5e-3 : 2.5e-3);
    error[halved] = std::abs(spun.joints[0].speed_rad_s.back() - exact);
  }
  EXPECT_NEAR(error[0] / error[1], 4.0, 0.3);  // next order: h b/J = 7 % of it
}

// Thrown at a stiff stop it leaves as fast as it came, after half a period of its oscillation,
// which is shorter than three of the steps asked for.
TEST(Simulation, BouncesOffAStiffStop) {
  actuator::Actuator actuator = simple_actuator();
  const double stiffness = 5e4;
  const double half_period_s = std::numbers::pi * std::sqrt(0.03 / stiffness);
  actuator.effects = {effect("upper_end_stop", {stiffness, 0.1})};
  const double start = 2.0;
  const auto excited = excitation(0.2, 1e-3, nothing);
  const SimulatedRun thrown = run(Load::kFree, actuator, excited, {0.0, start, {}, {}}, 1e-3);
  EXPECT_NEAR(thrown.joints[0].speed_rad_s.back(), -start, 1e-3 * start);
  EXPECT_NEAR(thrown.joints[0].position_rad.back(),
              0.1 - start * (0.2 - 0.1 / start - half_period_s), 1e-3);
}

// A pendulum of small swing: period 2 pi sqrt(J / (m g l)), longer by A^2/16.
TEST(Simulation, SwingsWithAPendulumsPeriod) {
  const Load load = Load::kPendulum;
  const double inertia = 0.02 + 1.0 * 0.09 + 0.01;
  const double amplitude = 0.05;
  const double period_s = 2.0 * std::numbers::pi * std::sqrt(inertia / (9.81 * 0.3)) *
                          (1.0 + amplitude * amplitude / 16.0);
  const auto excited = excitation(10.0 * period_s, period_s / 1000.0, nothing);
  const SimulatedRun swung = run(load, simple_actuator(), excited, {amplitude, 0.0, {}, {}});
  EXPECT_NEAR(swung.joints[0].position_rad.back(), amplitude, 1e-5 * amplitude);
  EXPECT_NEAR(swung.joints[0].speed_rad_s.back(), 0.0, 1e-4 * amplitude);
}

// Torque after a step of the command: 1 - exp(-t/T); its integral moves the inertia.
TEST(Simulation, LagFollowsAStepExponentially) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("torque_lag", {0.02})};
  const auto excited = excitation(0.2, 1e-3, [](double t) { return t < 0.0005 ? 0.0 : 1.0; });
  const SimulatedRun stepped = run(Load::kFree, actuator, excited);
  const double inertia = 0.03;
  for (std::size_t i = 5; i < excited.time_s.size(); ++i) {
    // The command rises over the first millisecond: as a step in its middle, to (1 ms/T)^2/24.
    const double t = excited.time_s[i] - 0.0005;
    const double torque = 1.0 - std::exp(-t / 0.02);
    const double speed = (t - 0.02 * torque) / inertia;
    EXPECT_NEAR(stepped.joints[0].acceleration_rad_s2[i] * inertia, torque, 2e-4);
    EXPECT_NEAR(stepped.joints[0].speed_rad_s[i], speed, 2e-3);
  }
}

// Held as long as friction can: c = 0.5 Nm holds 0.4 A, and lets 0.6 A go; the first slip of a ramp
// of 0.1 A/s comes at 5 s, then 0.03 a = 0.1 (t - 5) gives the position (t - 5)^3/6 0.1/0.03.
TEST(Simulation, SticksExactlyAndBreaksAwayInTime) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("coulomb_friction", {0.5})};
  const auto excited = excitation(6.0, 1e-3, [](double t) { return 0.1 * t; });
  const SimulatedRun pushed = run(Load::kFree, actuator, excited);
  const JointTrace& trace = pushed.joints[0];
  for (std::size_t i = 0; i <= 4999; ++i) ASSERT_EQ(trace.position_rad[i], 0.0);
  EXPECT_NEAR(trace.position_rad[6000], 0.1 / 0.03 / 6.0, 1e-3 / 0.6 * 0.1 / 0.03);
}

// Breakaway above sliding: starts at the breakaway torque, not at the Coulomb one.
TEST(Simulation, BreaksAwayAtTheBreakawayTorque) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("stribeck_friction", {0.3, 0.5, 0.1})};
  const auto excited = excitation(6.0, 1e-3, [](double t) { return 0.1 * t; });
  const JointTrace trace = run(Load::kFree, actuator, excited).joints[0];
  EXPECT_EQ(trace.position_rad[4990], 0.0);
  EXPECT_GT(trace.position_rad[5100], 1e-4);
}

// On a slope that friction can hold it rests for ever: 0.5 Nm hold m g l sin q = 0.4.
TEST(Simulation, RestsOnASlope) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("coulomb_friction", {0.5})};
  const double angle = std::asin(0.4 / (9.81 * 0.3));
  const auto excited = excitation(1.0, 1e-2, nothing);
  const JointTrace trace = run(Load::kPendulum, actuator, excited, {angle, 0.0, {}, {}}).joints[0];
  EXPECT_EQ(trace.position_rad.back(), angle);
  EXPECT_NEAR(trace.torque_Nm.back(), 0.4, 1e-12);  // what the load takes of the actuator
}

// A gear that cannot be driven back (k = 1) holds any load.
TEST(Simulation, SelfLockingGearHolds) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("load_dependent_friction", {0.5, 1.0})};
  const auto excited = excitation(0.5, 1e-3, nothing);
  const JointTrace trace = run(Load::kPendulum, actuator, excited, {1.0, 0.0, {}, {}}).joints[0];
  EXPECT_NEAR(trace.position_rad.back(), 1.0, 1e-9);
}

// Sticking and slipping, a train whose gap is nearly nothing moves as the rigid one does: a motor
// that stops against a load which still moves must not stop the clock.
TEST(Simulation, NarrowGapFollowsTheRigidTrain) {
  const auto excited = excitation(1.0, 1e-2, [](double t) { return -2.0 + 1.5 * t; });
  actuator::Actuator rigid = simple_actuator();
  rigid.effects = {effect("coulomb_friction", {0.5})};
  actuator::Actuator loose = rigid;
  loose.effects.push_back(effect("backlash", {1e-4}));
  const Load load = Load::kPendulum;
  for (double start_rad = -0.9; start_rad < 0.95; start_rad += 0.1) {
    for (const double speed_rad_s : {0.0, 0.5, -0.5}) {
      const JointStart start{start_rad, speed_rad_s, {}, {}};
      const JointTrace a = run(load, rigid, excited, start).joints[0];
      const JointTrace b = run(load, loose, excited, start).joints[0];
      EXPECT_NEAR(a.position_rad.back(), b.position_rad.back(), 0.01)
          << start_rad << " " << speed_rad_s;
    }
  }
}

// Two inertias and a spring: the twist swings at sqrt(k (1/Jm + 1/Jl)).
TEST(Simulation, TwistSwingsAtItsOwnFrequency) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("torsional_compliance", {200.0, 0.0})};
  const double omega = std::sqrt(200.0 * (1.0 / 0.01 + 1.0 / 0.02));
  const double period_s = 2.0 * std::numbers::pi / omega;
  // A torque step T winds the spring to the mean T/(Jm w^2) and back to nothing after one period.
  const auto excited = excitation(5.0 * period_s, period_s / 200.0, [](double) { return 1.0; });
  const JointTrace trace = run(Load::kFree, actuator, excited, {}, period_s / 2000.0).joints[0];
  const double mean_rad = 1.0 / (0.01 * omega * omega);
  const auto twist = [&](std::size_t i) {
    return trace.motor_position_rad[i] / 10.0 - trace.position_rad[i];
  };
  for (std::size_t i = 0; i < excited.time_s.size(); ++i) {
    const double exact = mean_rad * (1.0 - std::cos(omega * excited.time_s[i]));
    EXPECT_NEAR(twist(i), exact, 2e-3 * mean_rad);
  }
}

// i = V/R (1 - exp(-R t/L)) with the rotor held by friction.
TEST(Simulation, CurrentRisesWithTheWindingsTimeConstant) {
  actuator::Actuator actuator = simple_actuator();
  actuator.motor.inductance_q_H = 1e-3;
  actuator.effects = {effect("coulomb_friction", {1000.0})};
  auto excited = excitation(
      0.02, 1e-4, [](double t) { return t < 5e-5 ? 0.0 : 5.0; }, DriveKind::kVoltage);
  SimulationOptions options;
  options.inductance = true;
  const JointTrace trace =
      simulate(*simple_plant(Load::kFree), {&actuator}, excited, {{}}, options).joints[0];
  // As in the dc convention the resistance is that of two phases in series, so is the inductance.
  const double time_constant_s = 2.0 * 1e-3 / 0.5;
  for (std::size_t i = 2; i < excited.time_s.size(); ++i) {
    const double exact = 10.0 * (1.0 - std::exp(-(excited.time_s[i] - 5e-5) / time_constant_s));
    EXPECT_NEAR(trace.current_A[i], exact, 1e-3);
  }
}

// Constant loss into two nodes: two exponentials, from the eigenvalues of the 2 by 2 system.
TEST(Simulation, WarmsByTwoExponentials) {
  actuator::Actuator actuator = simple_actuator();
  actuator.thermal = actuator::Thermal{1.0, 2.0, 20.0, 100.0, 400.0, 300.0};
  actuator.effects = {effect("coulomb_friction", {1000.0}),
                      effect("winding_resistance_temperature", {0.0})};
  const auto excited = excitation(200.0, 0.1, [](double) { return 10.0; });
  const JointTrace trace =
      run(Load::kFree, actuator, excited, {0.0, 0.0, 300.0, 300.0}, 0.1).joints[0];
  const double loss_W = 0.5 * 100.0;
  // d/dt [x, y] = [-1/20, 1/20; 1/100, -1.5/100] [x, y] + [P/20, 0]; steady 150 and 100 K above.
  const double a = -1.0 / 20.0, b = 1.0 / 20.0, c = 1.0 / 100.0, d = -1.5 / 100.0;
  const double root = std::sqrt((a - d) * (a - d) / 4.0 + b * c);
  const double slow = (a + d) / 2.0 + root;
  const double fast = (a + d) / 2.0 - root;
  const double x_end = loss_W * 3.0, y_end = loss_W * 2.0;
  // Deviations (x, y) = u (b, slow - a) e^slow t + v (b, fast - a) e^fast t, from (-x_end, -y_end).
  const double v = (-y_end + x_end * (slow - a) / b) / (fast - slow);
  const double u = -x_end / b - v;
  for (std::size_t i = 0; i < excited.time_s.size(); i += 100) {
    const double t = excited.time_s[i];
    const double x = x_end + b * (u * std::exp(slow * t) + v * std::exp(fast * t));
    EXPECT_NEAR(trace.winding_K[i], 300.0 + x, 1e-3) << t;
  }
}

// A servo's own controller: at rest the duty's torque balances gravity.
TEST(Simulation, PositionControllerSettlesWhereTorquesBalance) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("viscous_friction", {1.0})};
  Excitation excited = excitation(
      8.0, 5e-3, [](double) { return 0.5; }, DriveKind::kPosition);
  excited.joints[0].position_gain_1_rad = 0.4;
  const JointTrace trace = run(Load::kPendulum, actuator, excited).joints[0];
  const double q = trace.position_rad.back();
  EXPECT_NEAR(0.4 * (0.5 - q) * 48.0 / 0.5 * 1.0, 9.81 * 0.3 * std::sin(q), 1e-6);
}

// Oracle: the same run with all traces.
TEST(Simulation, MovesAlikeWhereMotionAloneIsTraced) {
  actuator::Actuator drive = simple_actuator();
  drive.effects = {effect("coulomb_friction", {0.3}), effect("presliding_friction", {0.2, 20.0})};
  const Excitation played = excitation(1.0, 0.01, [](double t) { return std::sin(9.0 * t); });
  const std::unique_ptr<Plant> plant = simple_plant(Load::kPendulum);
  SimulationOptions options;
  const SimulatedRun all = simulate(*plant, {&drive}, played, {JointStart{}}, options);
  options.traces_motion_only = true;
  const SimulatedRun motion = simulate(*plant, {&drive}, played, {JointStart{}}, options);
  EXPECT_EQ(motion.joints[0].position_rad, all.joints[0].position_rad);
  EXPECT_EQ(motion.joints[0].speed_rad_s, all.joints[0].speed_rad_s);
  EXPECT_TRUE(motion.joints[0].torque_Nm.empty());
}

}  // namespace
}  // namespace torquewright::simulation
