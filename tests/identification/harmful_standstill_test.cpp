// SPDX-License-Identifier: Apache-2.0
// A joint that moves and rests while its motor works against torques of which the rig states
// nothing, by closed forms of the time. Oracle: it has no friction at all, by construction. Driven
// again by its current the free load runs away, and friction that holds it still follows the
// position best; in the balance of torques it is an error of its own size.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "identification/answer/analysis.hpp"

namespace torquewright::identification::harmful_standstill_test {
namespace {

constexpr double kRatio = 100.0, kTorqueConstant_Nm_A = 0.1, kInertia_kg_m2 = 5.0;
constexpr double kStroke_rad = 0.7, kMove_s = 0.8, kCycle_s = 2.0;

/// To and fro, each time with a rest behind it.
double angle_rad(double t) {
  const double cycle = std::floor(t / kCycle_s);
  const double s = std::min((t - kCycle_s * cycle) / kMove_s, 1.0);
  const double way = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
  return kStroke_rad * (std::fmod(cycle, 2.0) == 0.0 ? way : 1.0 - way);
}

/// What the joints beyond the rig take.
double unstated_Nm(std::size_t run, double t) {
  const auto shift = static_cast<double>(run);
  return 150.0 * std::sin(1.3 * t + shift) + 100.0 * std::sin(3.1 * t + 2.0 * shift) +
         80.0 * std::sin(0.37 * t + 0.5 * shift);
}

Log log_of_arm() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> unit(0.0, 1.0);
  Log log;
  for (std::size_t r = 0; r < 3; ++r) {
    Run run;
    run.name = "run_" + std::to_string(r);
    (r == 2 ? log.holdout_runs : log.train_runs).push_back(run.name);
    run.joints.resize(1);
    for (int k = 0; k < 3000; ++k) {
      const double t = 0.01 * k;
      run.time_s.push_back(t);
      run.joints[0][Quantity::kOutputPosition].push_back(angle_rad(t) + 2e-4 * unit(random));
      run.joints[0][Quantity::kMotorCurrent].push_back(
          unstated_Nm(r, t) / (kRatio * kTorqueConstant_Nm_A) + 0.05 * unit(random));
    }
    run.masked.assign(run.time_s.size(), 0);
    log.runs.push_back(std::move(run));
  }
  return log;
}

TEST(HarmfulStandstill, WhatRaisesTheBalancesErrorIsNotNamed) {
  Rig rig;
  rig.joints = {""};
  rig.load.type = LoadType::kFree;
  rig.load.inertia_kg_m2 = kInertia_kg_m2;
  actuator::Actuator actuator;
  actuator.motor.torque_constant_Nm_A = kTorqueConstant_Nm_A;
  actuator.motor.resistance_ohm = 0.3;
  actuator.motor.pole_pairs = 7;
  actuator.drive.bus_voltage_V = 48.0;
  actuator.drive.peak_current_A = 60.0;
  actuator.transmission.ratio = kRatio;
  const Log log = log_of_arm();
  const std::vector<EquationResult> results = analyse(rig, log, 0, {&actuator}, {});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].verdict, Verdict::kUnexplained);
  EXPECT_EQ(results[1].quantity, "output_position_rad");
  EXPECT_TRUE(results[1].added.empty());
  // The position alone speaks for it, so that the balance is what refuses.
  ASSERT_EQ(results[1].rejected.size(), 1U);
  EXPECT_NE(results[1].rejected[0].reason.find("in motor_current_A it raises the error"),
            std::string::npos)
      << results[1].rejected[0].reason;
}

}  // namespace
}  // namespace torquewright::identification::harmful_standstill_test
