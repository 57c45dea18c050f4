// SPDX-License-Identifier: Apache-2.0
// Which runs are held out where the rig names none. Oracle: the order of the friction that was put
// into the runs.
#include "identification/answer/alike_split.hpp"

#include <gtest/gtest.h>

#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::alike_split_test {
namespace {

using Names = std::vector<std::string>;

struct Case {
  made::MadeBench made;
  Log log = made.log([](const made::Made&) { return 0.0; });

  /// Friction of these sizes, run by run, on the sensor's shaft.
  explicit Case(const std::array<double, made::MadeBench::kRuns>& friction_Nm) {
    for (std::size_t r = 0; r < log.runs.size(); ++r) {
      log.runs.change(r, [&](Run& run) {
        std::vector<double>& torque_Nm = run.joints[0][Quantity::kOutputTorque];
        for (std::size_t k = 0; k < torque_Nm.size(); ++k) {
          torque_Nm[k] -= friction_Nm[r] * made::sign(made::MadeBench::speed_rad_s(
                                               r, 0.005 * static_cast<double>(k)));
        }
      });
    }
  }
  void split() { split_alike(log, made.rig, {&made.actuator}); }
};

TEST(AlikeSplit, StaysWhereBothPartsHaveAsMuchToExplain) {
  for (const auto& sizes : {std::array{0.3, 0.3, 0.3, 0.3}, std::array{0.0, 0.0, 0.0, 0.0},
                            std::array{0.3, 0.3, 0.3, 0.6}}) {
    Case alike(sizes);
    alike.split();
    EXPECT_EQ(alike.log.holdout_runs, Names{"run_3"});
    EXPECT_TRUE(alike.log.findings.empty());
  }
}

// Nothing that is fitted shows what the held-out run does; then the other way round.
TEST(AlikeSplit, GivesTheRunThatShowsItToTheFit) {
  for (const auto& sizes : {std::array{0.03, 0.06, 0.04, 1.0}, std::array{1.0, 0.06, 0.05, 0.03}}) {
    Case lopsided(sizes);
    lopsided.split();
    EXPECT_EQ(lopsided.log.holdout_runs, Names{"run_1"}) << "the second by what is left in it";
    EXPECT_EQ(lopsided.log.train_runs, (Names{"run_0", "run_2", "run_3"}));
    ASSERT_EQ(lopsided.log.findings.size(), 1u);
    EXPECT_TRUE(lopsided.log.findings[0].sentence.ends_with(": run_1"));
  }
}

TEST(AlikeSplit, LeavesTheUsersChoiceAlone) {
  Case stated({0.03, 0.06, 0.04, 1.0});
  stated.made.rig.holdout_runs = {"run_3"};
  stated.split();
  EXPECT_EQ(stated.log.holdout_runs, Names{"run_3"});
}

}  // namespace
}  // namespace torquewright::identification::alike_split_test
