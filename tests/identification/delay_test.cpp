// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "identification/alignment.hpp"
#include "identification/delay_choice.hpp"
#include "identification/folds.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::delay_test {
namespace {

using made::Made;
using made::MadeBench;

std::optional<Delay> delay_of(const std::function<double(const Made&)>& added, double late_s) {
  const MadeBench rig;
  const Log log = rig.log(added, 0.05, late_s);
  const Bench bench = rig.bench(log);
  return find_delay(bench, prepare(log, bench, noise_levels(log, 0), {}), run_folds(log));
}

double friction(const Made& at) { return -0.4 * made::sign(at.speed_rad_s) - 0.2 * at.speed_rad_s; }

// Oracle: the delay that was put into the sensor; 0.3 ms is a sixteenth of a sample of the log.
TEST(Alignment, FindsHowLateTheSensorIsBesideFriction) {
  for (const double late_s : {0.012, 0.078}) {
    const auto delay = delay_of(friction, late_s);
    ASSERT_TRUE(delay) << late_s;
    EXPECT_EQ(delay->channel, Quantity::kOutputTorque);
    EXPECT_NEAR(delay->delay_s, late_s, 3e-4);
    EXPECT_GT(delay->error_s, 0.0);
  }
}

// A sensor that is early is a drive that is late.
TEST(Alignment, NamesTheOtherChannelWhereTheSensorIsEarly) {
  const auto delay = delay_of(friction, -0.02);
  ASSERT_TRUE(delay);
  EXPECT_EQ(delay->channel, Quantity::kMotorCurrent);
  EXPECT_NEAR(delay->delay_s, 0.02, 3e-4);
}

// Missing viscous friction moves the torque of a sine like a delay; the rich model takes it up.
TEST(Alignment, DoesNotTakeFrictionForADelay) { EXPECT_FALSE(delay_of(friction, 0.0)); }

// One run alone is cut into pieces, so that the rich model can be left out and fitted there too:
// the bare one would take friction for a delay.
TEST(Alignment, OfOneRunDoesNotTakeFrictionForADelayEither) {
  const MadeBench rig;
  for (const double late_s : {0.0, 0.03}) {
    const Log several = rig.log(friction, 0.05, late_s);
    Log log = several;
    log.runs = Runs();
    log.runs.push_back(several.runs[0]);
    log.train_runs = {"run_0"};
    log.holdout_runs.clear();
    const Bench bench = rig.bench(log);
    const auto delay =
        find_delay(bench, prepare(log, bench, noise_levels(log, 0), {}), run_folds(log));
    EXPECT_EQ(delay.has_value(), late_s > 0.0);
    EXPECT_NEAR(delay ? delay->delay_s : 0.0, late_s, 3e-4);
  }
}

// The minimum lies at the end of the range that is searched.
TEST(Alignment, IsSilentBeyondItsRange) { EXPECT_FALSE(delay_of(friction, 0.19)); }

EquationResult result(double train_rms, double holdout_rms, Verdict verdict) {
  EquationResult made;
  made.before = {1.0, 1.1};
  made.after = {train_rms, holdout_rms};
  made.verdict = verdict;
  return made;
}

// Oracle: docs/derivations/identification.md section 3: 5 % better than without.
TEST(DelayChoice, NamesADelayThatLeavesClearlyLess) {
  EquationResult aligned = result(0.47, 0.5, Verdict::kNothingMissing);
  aligned.before = {0.47, 0.5};
  aligned.rejected = {{"channel_delay", "small"}};
  Delay delay;
  delay.channel = Quantity::kOutputTorque;
  delay.delay_s = 0.03;
  delay.error_s = 0.001;
  const EquationResult chosen =
      with_delay_if_better(result(0.5, 0.5, Verdict::kUnexplained), aligned, delay);
  ASSERT_EQ(chosen.added.size(), 1u);
  EXPECT_EQ(chosen.added[0].effect, "channel_delay");
  EXPECT_EQ(chosen.added[0].parameters["channel"], "output_torque_Nm");
  EXPECT_EQ(chosen.added[0].parameters["delay_s"], 0.03);
  EXPECT_EQ(chosen.added[0].holdout_rms_before, 1.1);
  EXPECT_EQ(chosen.added[0].holdout_rms_after, 0.5);
  EXPECT_EQ(chosen.before.holdout_rms, 1.1);  // of the log as it was
  EXPECT_TRUE(chosen.rejected.empty());
  EXPECT_EQ(chosen.verdict, Verdict::kExplained);
}

TEST(DelayChoice, KeepsThePlainResultWhereItIsHardlyWorse) {
  const EquationResult chosen = with_delay_if_better(
      result(0.5, 0.5, Verdict::kUnexplained), result(0.48, 0.48, Verdict::kNothingMissing), {});
  EXPECT_TRUE(chosen.added.empty());
  EXPECT_EQ(chosen.verdict, Verdict::kUnexplained);
}

TEST(DelayChoice, OfWhatLeavesStructureExplainsInPart) {
  const EquationResult chosen = with_delay_if_better(result(0.5, 0.5, Verdict::kUnexplained),
                                                     result(0.2, 0.2, Verdict::kUnexplained), {});
  EXPECT_EQ(chosen.verdict, Verdict::kPartlyExplained);
}

}  // namespace
}  // namespace torquewright::identification::delay_test
