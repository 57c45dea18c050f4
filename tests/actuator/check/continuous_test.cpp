// SPDX-License-Identifier: Apache-2.0
// What a motion takes in the root mean square against what may last. The simple actuator turns one
// ampere into one Nm at the joint, 0.1 Nm at the motor.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/actuator/check/checked_joint.hpp"

namespace torquewright::actuator {
namespace {

using check_test::Checked;
using check_test::has_finding;
using check_test::motion;

constexpr double kRounding = 1e-9;  // relative: numbers go through a file's decimals

double at_5(double) { return 5.0; }
double holds(double) { return 4.48; }
double ramp(double t) { return 3.0 * t; }

Actuator rated(double continuous_A) {
  Actuator actuator = test::simple_actuator();
  actuator.drive.continuous_current_A = continuous_A;
  return actuator;
}

const ContinuousUse& current_of(const CheckReport& report) {
  return report.drives[0].interpretation.continuous_current;
}

// Oracle: closed form. A constant is its own rms; the trapezoidal rule over n intervals makes
// 1/3 + 1/(6 n^2) of the integral of t^2.
TEST(Continuous, RmsIsThatOfTheSignal) {
  Checked checked(rated(2.0));
  const CheckReport constant = checked.report(motion(10, nullptr, at_5, holds));
  EXPECT_NEAR(current_of(constant).rms, 4.48, 4.48 * kRounding);
  EXPECT_NEAR(*current_of(constant).margin(), -2.48, 4.48 * kRounding);
  const double expected = 3.0 * std::sqrt(1.0 / 3.0 + 1.0 / 600.0);
  EXPECT_NEAR(current_of(checked.report(motion(10, nullptr, at_5, ramp))).rms, expected,
              expected * kRounding);
}

TEST(Continuous, AboveTheLimitTheMotionFails) {
  for (const double limit_A : {4.48 * (1.0 - 1e-6), 4.48 * (1.0 + 1e-6)}) {
    const CheckReport report = Checked(rated(limit_A)).report(motion(4, nullptr, at_5, holds));
    const bool is_above = limit_A < 4.48;
    EXPECT_EQ(report.verdict, is_above ? Verdict::kFail : Verdict::kPass);
    EXPECT_EQ(has_finding(report, "rms-current", Severity::kViolation), is_above);
  }
}

// Oracle: closed form of equation (8): 1 s of motion, 2 s of pause, however many runs.
TEST(Continuous, ThePauseCounts) {
  for (const std::size_t runs : {1u, 4u}) {
    Checked checked(rated(2.0));
    checked.request().runs = runs;
    checked.request().pause_s = 2.0;
    EXPECT_NEAR(current_of(checked.report(motion(4, nullptr, at_5, holds))).rms,
                4.48 / std::sqrt(3.0), 4.48 * kRounding);
  }
}

// Oracle: closed form of equation (9), and the check itself just beside that pause.
TEST(Continuous, TellsThePauseThatMeetsTheLimit) {
  Checked checked(rated(2.0));
  checked.request().runs = 100000;
  const std::string held = motion(4, nullptr, at_5, holds);
  const CheckReport without = checked.report(held);
  EXPECT_EQ(without.verdict, Verdict::kFail);
  const double pause_s = 4.48 * 4.48 / 4.0 - 1.0;
  EXPECT_NEAR(*current_of(without).pause_s, pause_s, pause_s * kRounding);
  checked.request().pause_s = pause_s * 0.9999;
  EXPECT_EQ(checked.report(held).verdict, Verdict::kFail);
  checked.request().pause_s = pause_s * 1.0001;
  EXPECT_EQ(checked.report(held).verdict, Verdict::kPass);
}

TEST(Continuous, WithoutALimitThereIsNoVerdict) {
  const CheckReport report = Checked().report(motion(4, nullptr, at_5, holds));
  EXPECT_EQ(report.verdict, Verdict::kPass);
  EXPECT_NEAR(current_of(report).rms, 4.48, 4.48 * kRounding);
  EXPECT_FALSE(current_of(report).limit);
  EXPECT_FALSE(current_of(report).margin());
}

// Oracle: closed form, 4.48 Nm at the joint is 0.448 Nm at the motor.
TEST(Continuous, RatedTorqueIsHeldAgainstItsOwnSide) {
  for (const bool at_joint : {true, false}) {
    const double rms_Nm = at_joint ? 4.48 : 0.448;
    for (const double factor : {0.999, 1.001}) {
      Actuator actuator = test::simple_actuator();
      actuator.datasheet.emplace();
      actuator.datasheet->joint_side = at_joint;
      actuator.datasheet->rated_torque_Nm = factor * rms_Nm;
      const CheckReport report = Checked(actuator).report(motion(4, nullptr, at_5, holds));
      EXPECT_NEAR(report.drives[0].interpretation.continuous_torque.rms, rms_Nm,
                  rms_Nm * kRounding);
      EXPECT_EQ(has_finding(report, "rms-torque", Severity::kViolation), factor < 1.0);
      EXPECT_EQ(report.verdict, factor < 1.0 ? Verdict::kFail : Verdict::kPass);
    }
  }
}

}  // namespace
}  // namespace torquewright::actuator
