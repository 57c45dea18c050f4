// SPDX-License-Identifier: Apache-2.0
// Oracle: conservation of energy. What is put in less what is lost is stored, up to the scheme's
// order, with every mechanism at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/simulation/simple_drive.hpp"

namespace torquewright::simulation {
namespace {

std::vector<actuator::Effect> everything() {
  return {effect("viscous_friction", {0.02}),
          effect("stribeck_friction", {0.1, 0.2, 0.3}),
          effect("eddy_current_drag", {0.1, 0.8}),
          effect("parallel_spring", {0.5, 0.2}),
          effect("upper_end_stop", {2.0, 0.3}),
          effect("lower_end_stop", {2.0, -0.1}),
          effect("load_dependent_friction", {0.1, 0.08}),
          harmonic_effect("cogging_torque", {{4.0, 0.05, 0.3}}),
          harmonic_effect("gear_ripple", {{3.0, 0.05, 0.1}}, true),
          effect("torque_lag", {0.01})};
}

double imbalance_J(const SimulatedRun& run) {
  const WorkAccount& work = run.work;
  return work.motor_J + work.load_J + work.periodic_J - work.friction_J - work.mesh_J -
         work.damper_J - work.stored_J;
}

double turnover_J(const SimulatedRun& run) {
  return std::abs(run.work.motor_J) + run.work.friction_J + run.work.mesh_J;
}

double shaken(double t) { return 2.0 * std::sin(3.0 * t) + 1.5 * std::sin(7.1 * t); }

struct Case {
  Load load;
  double gap_rad;
  double stiffness_Nm_rad;
  double share;  ///< Of the turnover that may be missing.
};

class EnergyBalance : public testing::TestWithParam<Case> {};

TEST_P(EnergyBalance, Closes) {
  const Case& the = GetParam();
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = everything();
  if (the.gap_rad > 0.0) actuator.effects.push_back(effect("backlash", {the.gap_rad}));
  if (the.stiffness_Nm_rad > 0.0) {
    actuator.effects.push_back(effect("torsional_compliance", {the.stiffness_Nm_rad, 0.2}));
  }
  Excitation excited = excitation(4.0, 1e-3, shaken);
  for (const double t : excited.time_s)
    excited.joints[0].speed_rad_s.push_back(2.0 * std::sin(4.0 * t));
  const SimulatedRun done = run(the.load, actuator, excited, {}, 1e-4);
  ASSERT_TRUE(done.is_finite);
  EXPECT_GT(done.work.friction_J, 0.1);
  EXPECT_GT(done.work.mesh_J, 0.1);
  EXPECT_LT(std::abs(imbalance_J(done)), the.share * turnover_J(done)) << imbalance_J(done);
}

INSTANTIATE_TEST_SUITE_P(Plants, EnergyBalance,
                         testing::Values(Case{Load::kFree, 0.0, 0.0, 1e-4},
                                         Case{Load::kPendulum, 0.0, 0.0, 1e-4},
                                         Case{Load::kLinearAxis, 0.0, 0.0, 1e-4},
                                         Case{Load::kDynamometer, 0.0, 0.0, 1e-3},
                                         Case{Load::kPendulum, 0.0, 300.0, 1e-3},
                                         Case{Load::kPendulum, 0.01, 0.0, 5e-3},
                                         Case{Load::kDynamometer, 0.01, 400.0, 5e-3}));

/// Three periods of the motor's torque, up to 1 Nm, against an output that is held. It grows during
/// the first, so softly that the rotor does not swing.
SimulatedRun wound_up(double rate_rad_s, double longest_step_s) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("torsional_compliance", {200.0, 0.0}),
                      effect("strain_wave_hysteresis", {0.4, 0.002})};
  const double period_s = 2.0 * std::numbers::pi / rate_rad_s;
  Excitation excited = excitation(3.0 * period_s, period_s / 2000.0, [=](double t) {
    const double share = t < period_s ? 0.5 - 0.5 * std::cos(0.5 * rate_rad_s * t) : 1.0;
    return share * std::sin(rate_rad_s * t);
  });
  excited.joints[0].speed_rad_s.assign(excited.time_s.size(), 0.0);
  return run(Load::kDynamometer, actuator, excited, {}, longest_step_s);
}

/// Torque over twist, once around the third period; and the twist's greatest size.
std::pair<double, double> loop_of(const JointTrace& trace) {
  const auto twist_rad = [&](std::size_t i) {
    return trace.motor_position_rad[i] / 10.0 - trace.position_rad[i];
  };
  double area_J = 0.0, most_rad = 0.0;
  for (std::size_t i = trace.torque_Nm.size() * 2 / 3; i + 1 < trace.torque_Nm.size(); ++i) {
    area_J +=
        0.5 * (trace.torque_Nm[i] + trace.torque_Nm[i + 1]) * (twist_rad(i + 1) - twist_rad(i));
    most_rad = std::max(most_rad, std::abs(twist_rad(i)));
  }
  return {area_J, most_rad};
}

// Oracle: the loop's area in closed form, docs/derivations/strain_wave_hysteresis.md eq. (4), for
// the twist that was reached, at either of two speeds. What begins off the loop falls by exp(-2
// X/s) in each half period, below 1e-3 of it in the third period.
TEST(StrainWaveGear, LosesItsLoopAtEverySpeed) {
  for (const double rate_rad_s : {1.0, 2.0}) {
    const auto [area_J, most_rad] = loop_of(wound_up(rate_rad_s, 1e-4).joints[0]);
    const double m = std::tanh(most_rad / 0.002);
    EXPECT_NEAR(area_J, 4.0 * 0.4 * (most_rad - 0.002 * (m - m * m * m / 15.0)), 1e-3 * area_J);
    EXPECT_GT(area_J, 1e-3);
  }
}

// What it stores counts as lost until it is given back.
TEST(StrainWaveGear, ClosesTheBalanceOfEnergy) {
  const SimulatedRun done = wound_up(2.0, 1e-4);
  EXPECT_GT(done.work.damper_J, 1e-3);
  EXPECT_LT(std::abs(imbalance_J(done)), 1e-3 * done.work.damper_J) << imbalance_J(done);
}

// Two links, friction and gears in both joints: coupled stick and slip.
TEST(EnergyBalanceOfAnArm, Closes) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = everything();
  Excitation excited = excitation(4.0, 1e-3, shaken);
  excited.joints.push_back(excited.joints[0]);
  for (double& current : excited.joints[1].value) current *= -0.3;
  SimulationOptions options;
  options.longest_step_s = 1e-4;
  const SimulatedRun done =
      simulate(*simple_arm(), {&actuator, &actuator}, excited, {{}, {}}, options);
  ASSERT_TRUE(done.is_finite);
  EXPECT_LT(std::abs(imbalance_J(done)), 1e-3 * turnover_J(done));
}

// Both joints are held by friction that gravity cannot overcome; then a current moves the elbow
// alone (which turns too slowly to drag the shoulder along).
TEST(StickingArm, HoldsEachJointByItself) {
  actuator::Actuator stiff = simple_actuator();
  stiff.effects = {effect("coulomb_friction", {50.0})};
  actuator::Actuator loose = simple_actuator();
  loose.effects = {effect("coulomb_friction", {2.0})};
  Excitation excited = excitation(1.0, 1e-3, [](double) { return 0.0; });
  excited.joints.push_back(excited.joints[0]);
  for (std::size_t i = 500; i < excited.time_s.size(); ++i) excited.joints[1].value[i] = 2.8;
  const SimulatedRun done =
      simulate(*simple_arm(), {&stiff, &loose}, excited, {{0.4, 0.0, {}, {}}, {0.3, 0.0, {}, {}}});
  EXPECT_EQ(done.joints[0].position_rad.back(), 0.4);
  EXPECT_EQ(done.joints[1].position_rad[499], 0.3);
  EXPECT_GT(done.joints[1].position_rad.back(), 0.31);
}

}  // namespace
}  // namespace torquewright::simulation
