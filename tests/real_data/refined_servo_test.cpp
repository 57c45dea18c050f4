// SPDX-License-Identifier: Apache-2.0
// The servo's log from the voltage equation to a refined document, and that document's motion by
// simulation, which no part of the regression knows. Oracle: the study by hand of the same log:
// mean absolute position error, runs at gain 200 held out, viscous 0.094 rad, with load friction
// 0.052 to 0.058. (Constants fitted by simulation: bam_servos_test.cpp.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "identification/answer/identify.hpp"
#include "identification/answer/refined_json.hpp"
#include "io/documents/document.hpp"
#include "io/files/atomic_file.hpp"
#include "tests/real_data/bam_servos/servo.hpp"

namespace torquewright::identification {
namespace {

namespace fs = std::filesystem;

constexpr double kGoal_rad = 0.060;  ///< A study by hand with load friction: 0.052 to 0.058.

fs::path logs() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path data = variable != nullptr ? fs::path(variable)
                                            : fs::path(TORQUEWRIGHT_SOURCE_DIR) / "../shared/data";
  return data / "logs/bam_servos";
}

PositionScore motion_of(const ServoLog& log, const actuator::Actuator& actuator) {
  PositionScoreOptions options;
  options.longest_step_s = 1e-3;
  return position_score(log.rig, {&actuator}, log.held_out, options);
}

bool is_in_doubt(const EquationResult& equation, const std::string& effect) {
  return std::any_of(
      equation.confounded.begin(), equation.confounded.end(), [&](const Confounded& group) {
        return !group.exact &&
               std::find(group.effects.begin(), group.effects.end(), effect) != group.effects.end();
      });
}

TEST(RefinedServo, LoadFrictionAloneIsCertainAndTheMotionIsRight) {
  const auto servo = read_servo(false);
  if (!servo) GTEST_SKIP() << "no ../shared/data/logs: the logs are not here";
  const fs::path rigs = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "tests/real_data/rigs";
  const JointActuator nominal{"", actuator::read_actuator(rigs / "bam_servos_actuator.json")};
  const Identification found = identify(
      {logs() / "xl330_train.csv", logs() / "xl330_heldout_kp200.csv"}, servo->rig, {nominal});
  EXPECT_EQ(found.verdict, Verdict::kPartlyExplained);
  const EquationResult& voltage = found.equations.front();
  ASSERT_EQ(voltage.quantity, "winding_voltage_V");
  ASSERT_FALSE(voltage.added.empty());
  EXPECT_EQ(voltage.added[0].effect, "load_dependent_friction");
  // Whatever else is named stands in a group that this log cannot tell apart.
  for (std::size_t k = 1; k < voltage.added.size(); ++k) {
    EXPECT_TRUE(is_in_doubt(voltage, voltage.added[k].effect)) << voltage.added[k].effect;
  }
  EXPECT_LT(voltage.after.holdout_rms, 0.75 * voltage.before.holdout_rms);
  const fs::path file = fs::temp_directory_path() / "torquewright_refined_servo.json";
  io::write_whole_file(file, refined_actuator(found, nominal).dump());
  const actuator::Actuator refined = actuator::read_actuator(file).actuator;
  fs::remove(file);
  const PositionScore after = motion_of(*servo, refined);
  EXPECT_LE(after.mean_absolute_rad, kGoal_rad);
  EXPECT_LT(after.rms_rad, motion_of(*servo, servo->nominal).rms_rad);
}

}  // namespace
}  // namespace torquewright::identification
