// SPDX-License-Identifier: Apache-2.0
// Oracle: published figures of a study of the same log: mean absolute position error, runs at gain
// 200 held out: viscous 0.094 rad, with load-dependent friction 0.052 to 0.058 rad.
#include <gtest/gtest.h>

#include "actuator/effects/library.hpp"
#include "tests/real_data/bam_servos/servo.hpp"

namespace torquewright::identification {
namespace {

constexpr double kPublishedBefore_rad = 0.094;
constexpr double kGoalAfter_rad = 0.060;
constexpr double kAgreement = 0.05;  ///< Of the published figure: another step, other bounds.

actuator::Effect effect(std::string_view name, std::vector<double> values) {
  actuator::Effect made;
  made.kind = actuator::find_effect(name);
  made.values = std::move(values);
  return made;
}

PositionScore held_out(const ServoLog& log, const actuator::Actuator& actuator) {
  PositionScoreOptions options;
  options.longest_step_s = 1e-3;
  return position_score(log.rig, {&actuator}, log.held_out, options);
}

// Constants as fit_servo found them on the training runs (docs/derivations/simulation.md section
// 6); the runs at gain 200 were never fitted.
TEST(BamServos, LoadDependentFrictionTakesTheErrorBelowTheGoal) {
  const auto log = read_servo(false);
  if (!log) GTEST_SKIP() << "no ../shared/data";
  actuator::Actuator viscous = log->nominal;
  viscous.motor.torque_constant_Nm_A = 0.27402;
  viscous.motor.resistance_ohm = 4.4065;
  viscous.motor.rotor_inertia_kg_m2 = 0.0016047;
  viscous.effects = {effect("viscous_friction", {0.017542})};
  const PositionScore before = held_out(*log, viscous);
  EXPECT_NEAR(before.mean_absolute_rad, kPublishedBefore_rad, kAgreement * kPublishedBefore_rad);
  actuator::Actuator loaded = log->nominal;
  loaded.motor.torque_constant_Nm_A = 0.36518;
  loaded.motor.resistance_ohm = 4.9975;
  loaded.motor.rotor_inertia_kg_m2 = 0.0012707;
  loaded.effects = {effect("viscous_friction", {0.006442}),
                    effect("load_dependent_friction", {0.2711, 0.54322})};
  const PositionScore after = held_out(*log, loaded);
  EXPECT_LT(after.mean_absolute_rad, kGoalAfter_rad);
  EXPECT_LT(after.rms_rad, before.rms_rad);
  ASSERT_EQ(after.runs.size(), 4u);
}

// Windows that begin anew at the measured state see less of what adds up.
TEST(BamServos, ShortWindowsHaveSmallerErrors) {
  const auto log = read_servo(false);
  if (!log) GTEST_SKIP() << "no ../shared/data";
  PositionScoreOptions windows;
  windows.window_s = 0.5;
  const PositionScore cut = position_score(log->rig, {&log->nominal}, log->held_out, windows);
  EXPECT_LT(cut.mean_absolute_rad, held_out(*log, log->nominal).mean_absolute_rad);
}

}  // namespace
}  // namespace torquewright::identification
