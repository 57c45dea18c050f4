// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/same_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/answer/identify.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/oracles/bench_log/scenario.hpp"

namespace torquewright::identification::same_rig_test {
namespace {

/// Stretches of 9 s, each a run and a fold, every sample usable.
std::vector<Signals> stretches(std::size_t count) {
  std::vector<Signals> all(count);
  for (std::size_t run = 0; run < count; ++run) {
    all[run].run = run;
    all[run].step_s = 0.01;
    all[run].at.resize(900);
    all[run].usable.assign(900, 1);
  }
  return all;
}

/// A residual of `slopes[run]` times one column, 200 rows in each of a run's 12 blocks or more,
/// with noise; the fit is to all of them together, of a constant that is stated as 1.
struct Runs {
  std::vector<Signals> signals;
  std::vector<std::size_t> folds;
  std::vector<std::string> names;
  ModelFit fit;

  Runs(const std::vector<double>& slopes, double sigma) : signals(stretches(slopes.size())) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (std::size_t run = 0; run < slopes.size(); ++run) {
      names.push_back("run_" + std::to_string(run));
      folds.push_back(run);
    }
    const Rows rows(signals, folds, {});
    double top = 0.0, bottom = 0.0;
    for (const Rows::Block& block : rows.blocks()) {
      BlockSums sums{Eigen::MatrixXd::Zero(1, 1), Eigen::VectorXd::Zero(1)};
      for (int i = 0; i < 200; ++i) {
        const double x = normal(random);
        sums.slopes(0, 0) += x * x;
        sums.descent[0] -= x * (slopes[block.run] * x + sigma * normal(random));
      }
      top -= sums.descent[0];
      bottom += sums.slopes(0, 0);
      fit.sums.push_back(sums);
    }
    const double mean = top / bottom;
    fit.coordinates = Eigen::VectorXd::Constant(1, 1.0 + mean);
    for (BlockSums& sums : fit.sums) sums.descent += mean * sums.slopes.col(0);
  }

  std::string objection() const {
    ForwardEquation equation;
    equation.pointers = {"/motor/torque_constant_Nm_A"};
    return runs_that_disagree(equation, Rows(signals, folds, {}), fit, names);
  }
};

// Oracle: closed form. Each run alone is fitted by its own slope: 1 and 1 + 2.
TEST(RunsThatDisagree, RunsThatAskForValuesThreeTimesApartAreNotOne) {
  const std::string said = Runs({0.0, 2.0, 0.0, 2.0}, 0.1).objection();
  EXPECT_NE(said.find("not of one rig: /motor/torque_constant_Nm_A comes out as"),
            std::string::npos);
  EXPECT_NE(said.find("3 in \"run_1\""), std::string::npos) << said;
}

// A factor of 1.8 is below two, however sure it is.
TEST(RunsThatDisagree, RunsThatAskForNearlyTheSameAreOne) {
  EXPECT_EQ(Runs({0.0, 0.8, 0.0}, 0.1).objection(), "");
}

// Each run's value has a standard error of 20/sqrt(2400) = 0.41 or so: the values are hardly known.
TEST(RunsThatDisagree, ValuesThatAreHardlyKnownDoNotSeparateRuns) {
  EXPECT_EQ(Runs({0.0, 2.0, 0.0}, 20.0).objection(), "");
}

/// The generator's bench with nothing missing, its torque constant called uncertain, and the
/// current's column multiplied in some of the runs.
Identification identified(std::uint64_t seed, double factor) {
  oracles::Scenario scenario = oracles::draw(oracles::LogClass::kNone, seed);
  scenario.rig["uncertain"] = {"/motor/torque_constant_Nm_A"};
  std::size_t current = 0;
  for (const auto& [column, use] : scenario.rig["columns"].items()) {
    if (use != "motor_current_A") continue;
    const auto& columns = scenario.log.columns;
    current = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) -
                                       columns.begin());
  }
  for (std::size_t run = 0; run < scenario.log.runs.size(); run += 2) {
    for (double& value : scenario.log.runs[run].columns.at(current)) value *= factor;
  }
  const test::ScratchFolder folder;
  const oracles::ScenarioFiles files = oracles::write_scenario(folder.path(), scenario);
  return identify(files.logs, read_rig(io::read_document(files.rig, "rig")),
                  {{"", actuator::read_actuator(files.actuator)}});
}

// Oracle: what was done to the log. With another scale of the current in every second run no one
// torque constant is true of all; without, the stated one is.
class SameRigLogs : public testing::TestWithParam<std::uint64_t> {};
TEST_P(SameRigLogs, ACurrentOfAnotherScaleInSomeRunsCannotTell) {
  const Identification found = identified(GetParam(), 3.0);
  EXPECT_EQ(found.verdict, Verdict::kCannotTell);
  bool is_said = false;
  for (const DataFinding& finding : found.findings) {
    is_said = is_said || (finding.weight == Weight::kError &&
                          finding.sentence.find("not of one rig") != std::string::npos);
  }
  EXPECT_TRUE(is_said);
}

TEST_P(SameRigLogs, RunsOfOneScaleAreOneRig) {
  const Identification found = identified(GetParam(), 1.0);
  EXPECT_NE(found.verdict, Verdict::kCannotTell);
  for (const DataFinding& finding : found.findings) EXPECT_NE(finding.weight, Weight::kError);
}

INSTANTIATE_TEST_SUITE_P(SameRig, SameRigLogs, testing::Values(0, 2, 3, 6));

}  // namespace
}  // namespace torquewright::identification::same_rig_test
