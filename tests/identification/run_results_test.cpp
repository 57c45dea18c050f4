// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/run_results.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/answer/analysis.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::run_results_test {
namespace {

using made::Made;
using made::MadeBench;

// Oracle: the whole curve. Every peak of a curve is in what is drawn of it, and nothing else.
TEST(Thinned, KeepsWhatSticksOut) {
  Curve curve;
  for (int i = 0; i < 100000; ++i) {
    curve.time_s.push_back(0.001 * i);
    curve.value.push_back(i == 31234 ? 50.0 : i == 77777 ? -40.0 : std::sin(0.01 * i));
  }
  curve.value[50000] = std::numeric_limits<double>::quiet_NaN();
  const Curve few = thinned(curve, 300);
  EXPECT_LE(few.value.size(), 601u);
  EXPECT_TRUE(std::is_sorted(few.time_s.begin(), few.time_s.end()));
  EXPECT_EQ(std::count(few.value.begin(), few.value.end(), 50.0), 1);
  EXPECT_EQ(std::count(few.value.begin(), few.value.end(), -40.0), 1);
  EXPECT_EQ(
      std::count_if(few.value.begin(), few.value.end(), [](double v) { return std::isnan(v); }), 1);
  for (std::size_t i = 0; i < few.value.size(); ++i) {
    const auto at = static_cast<std::size_t>(std::lround(few.time_s[i] / 0.001));
    EXPECT_TRUE(std::isnan(few.value[i]) || few.value[i] == curve.value[at]) << i;
  }
  EXPECT_EQ(thinned(few, 301).value.size(), few.value.size());
}

// Oracle: closed form. A sensor that is off by 0.5 Nm in all runs: the stated model leaves 0.5 Nm
// in each, the refined one the noise of 0.01 Nm, of which the band passes a part.
TEST(RunResults, SayWhatEachModelLeavesOfEachRun) {
  const MadeBench made;
  const Log log = made.log([](const Made&) { return 0.5; });
  const EquationResult torque = analyse(made.rig, log, 0, {&made.actuator}, {}).at(0);
  ASSERT_EQ(torque.runs.size(), MadeBench::kRuns);
  double worst_held_out = 0.0;
  for (const RunResult& run : torque.runs) {
    EXPECT_EQ(run.is_held_out, run.run == "run_3");
    EXPECT_NEAR(run.rms_before, 0.5, 0.01);
    EXPECT_LT(run.rms_after, 0.01);
    if (run.is_held_out) worst_held_out = run.rms_after;
    ASSERT_EQ(run.measured.value.size(), run.refined.value.size());
    for (std::size_t i = 0; i < run.measured.value.size(); ++i) {
      if (std::isnan(run.measured.value[i])) continue;  // A rest: the line ends.
      EXPECT_NEAR(run.measured.value[i] - run.stated.value[i], 0.5, 0.05);
      EXPECT_NEAR(run.measured.value[i] - run.refined.value[i], 0.0, 0.05);
    }
    ASSERT_FALSE(run.left_before.value.empty());
    for (const double left : run.left_before.value) {
      if (std::isnan(left)) continue;
      EXPECT_NEAR(left, 0.5, 0.05);
    }
    for (const double left : run.left_after.value) {
      if (std::isnan(left)) continue;
      EXPECT_NEAR(left, 0.0, 0.05);
    }
  }
  EXPECT_DOUBLE_EQ(worst_held_out, torque.after.holdout_rms);
}

// Oracle: closed form. Without a sensor the drive's channel is what was measured: a free inertia
// takes J q'' of N Kt i, and a current that reads half an ampere too much stands half an ampere
// above what the model predicts.
TEST(RunResults, HaveTheDrivesChannelOnItsOwnSideOfThePrediction) {
  constexpr double kInertia_kg_m2 = 0.2, kStep_s = 1e-3;
  MadeBench made;
  made.rig.load.type = LoadType::kFree;
  made.rig.load.inertia_kg_m2 = kInertia_kg_m2;
  Log log = made.log([](const Made&) { return 0.0; });
  for (std::size_t r = 0; r < MadeBench::kRuns; ++r) {
    log.runs.change(r, [r](identification::Run& run) {
      auto& joint = run.joints[0];
      joint[Quantity::kOutputTorque].clear();
      for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const double t = run.time_s[k];
        const double acceleration_rad_s2 =
            (MadeBench::speed_rad_s(r, t + kStep_s) - MadeBench::speed_rad_s(r, t - kStep_s)) /
            (2.0 * kStep_s);
        joint[Quantity::kMotorCurrent][k] =
            0.5 + kInertia_kg_m2 * acceleration_rad_s2 /
                      (MadeBench::kRatio * MadeBench::kTorqueConstant_Nm_A);
      }
    });
  }
  AnalysisOptions options;
  options.select = false;
  const EquationResult current = analyse(made.rig, log, 0, {&made.actuator}, options).at(0);
  ASSERT_EQ(current.quantity, "motor_current_A");
  ASSERT_FALSE(current.runs.empty());
  for (const RunResult& run : current.runs) {
    for (std::size_t i = 0; i < run.measured.value.size(); ++i) {
      if (std::isnan(run.measured.value[i])) continue;  // A rest: the line ends.
      EXPECT_NEAR(run.measured.value[i] - run.stated.value[i], 0.5, 0.05);
    }
    for (const double left : run.left_before.value) {
      if (std::isnan(left)) continue;
      EXPECT_NEAR(left, 0.5, 0.05);
    }
  }
}

}  // namespace
}  // namespace torquewright::identification::run_results_test
