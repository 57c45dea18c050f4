// SPDX-License-Identifier: Apache-2.0
// A joint that moves and rests while its motor works against torques of which the rig states
// nothing, by closed forms of the time. Oracle: it has no friction at all, by construction. Driven
// again by its current the free load runs away, and friction that holds it still follows the
// position best; in the balance of torques it is an error of its own size.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "identification/answer/analysis.hpp"
#include "tests/identification/free_joint.hpp"

namespace torquewright::identification::harmful_standstill_test {
namespace {

constexpr double kNm_per_A = 10.0;
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
  return test_logs::three_runs([&](std::size_t r, double t, Run& run) {
    run.joints[0][Quantity::kOutputPosition].push_back(angle_rad(t) + 2e-4 * unit(random));
    run.joints[0][Quantity::kMotorCurrent].push_back(unstated_Nm(r, t) / kNm_per_A +
                                                     0.05 * unit(random));
  });
}

TEST(HarmfulStandstill, WhatRaisesTheBalancesErrorIsNotNamed) {
  const test_logs::FreeJoint joint(5.0);
  const Log log = log_of_arm();
  const std::vector<EquationResult> results = analyse(joint.rig, log, 0, {&joint.actuator}, {});
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
