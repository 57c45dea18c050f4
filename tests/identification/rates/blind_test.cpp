// SPDX-License-Identifier: Apache-2.0
// What a regression over the motion cannot see: a gap with one encoder, friction at rest. Oracle:
// the truth that the generator put in, by a code of its own. Seeds that no rule was made by.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/answer/analysis.hpp"
#include "identification/reading/read_log.hpp"
#include "tests/long_run.hpp"
#include "tests/oracles/bench_log/scenario.hpp"

namespace torquewright::rates {
namespace {

using identification::EquationResult;
using identification::NamedEffect;

constexpr std::uint64_t kFirstBlindSeed = 2000;
/// Of each situation; all but one of them have to be told.
const int kLogs = test::is_long_run() ? 4 : 2;

struct Named {
  std::vector<NamedEffect> effects;
  double truth = 0.0;  ///< Of the parameter asked about.
  std::vector<EquationResult> equations;
};

Named identified(const std::string& situation, std::uint64_t seed, const std::string& parameter) {
  const auto folder =
      std::filesystem::path(testing::TempDir()) / fmt::format("blind_{}_{}", situation, seed);
  const oracles::Scenario scenario = oracles::draw_blind(situation, seed);
  const oracles::ScenarioFiles files = oracles::write_scenario(folder, scenario);
  const auto rig = identification::read_rig(io::read_document(files.rig, "rig"));
  const auto log = identification::read_log(files.logs, rig);
  const actuator::ReadActuator nominal = actuator::read_actuator(files.actuator);
  Named named;
  named.equations = identification::analyse(rig, log, 0, {&nominal.actuator});
  for (const EquationResult& equation : named.equations) {
    named.effects.insert(named.effects.end(), equation.added.begin(), equation.added.end());
  }
  for (const oracles::TrueEffect& effect : scenario.truth.effects) {
    if (effect.parameters.count(parameter) != 0) named.truth = effect.parameters.at(parameter);
  }
  std::filesystem::remove_all(folder);
  return named;
}

struct BlindCount {
  int found = 0;
  int wrong = 0;
  double worst = 0.0;         ///< Relative, of the parameter of those found with certainty.
  double worst_unsaid = 0.0;  ///< The same where it is beyond three of its own standard errors.
};

BlindCount count_blind(const std::string& situation, const std::string& effect,
                       const std::string& parameter) {
  BlindCount count;
  for (std::uint64_t seed = kFirstBlindSeed;
       seed < kFirstBlindSeed + static_cast<std::uint64_t>(kLogs); ++seed) {
    const Named named = identified(situation, seed, parameter);
    for (const EquationResult& equation : named.equations) {
      for (const NamedEffect& each : equation.added) {
        if (each.effect != effect) {
          ++count.wrong;
          continue;
        }
        ++count.found;
        if (!is_certain(equation, effect)) continue;
        const double off = std::abs(each.parameters.value(parameter, NAN) - named.truth);
        const double share = off / std::abs(named.truth);
        count.worst = std::max(count.worst, share);
        if (off <= 3.0 * each.parameters.standard_error(parameter)) continue;
        count.worst_unsaid = std::max(count.worst_unsaid, share);
      }
    }
  }
  return count;
}

// Flanks that rebound and a filter of 25 Hz leave the gap's width uncertain by a third.
TEST(BlindGap, IsFoundWithTheOutputsEncoder) {
  const BlindCount counted = count_blind("backlash_output_encoder", "backlash", "gap_rad");
  EXPECT_GE(counted.found, kLogs - 1);
  EXPECT_EQ(counted.wrong, 0);
  EXPECT_LT(counted.worst, 0.35);
}

// Where the load is modelled as well, one log cannot tell the gap from friction under load, and one
// leaves its width uncertain by 65 %, which it says.
TEST(BlindGap, IsFoundWithTheMotorsEncoder) {
  const BlindCount counted = count_blind("backlash_motor_encoder", "backlash", "gap_rad");
  EXPECT_GE(counted.found, kLogs - 1);
  EXPECT_EQ(counted.wrong, 0);
  EXPECT_LT(counted.worst_unsaid, 0.35);
}

TEST(BlindLogs, BreakawayIsFoundInStickAndSlip) {
  const BlindCount counted = count_blind("breakaway", "stribeck_friction", "breakaway_Nm");
  EXPECT_GE(counted.found, kLogs - 1);
  EXPECT_EQ(counted.wrong, 0);
  EXPECT_LT(counted.worst, 0.25);
}

TEST(BlindLogs, NothingIsNamedWhereNothingIsMissing) {
  const BlindCount counted = count_blind("nothing", "", "");
  EXPECT_EQ(counted.wrong, 0);
}

// The position by simulation confirms friction that the balance of torques found.
TEST(BlindLogs, SimulationConfirmsFrictionThatMostlyHolds) {
  const Named named = identified("standstill", kFirstBlindSeed, "coulomb_Nm");
  const auto position = std::find_if(
      named.equations.begin(), named.equations.end(),
      [](const EquationResult& each) { return each.quantity == "output_position_rad"; });
  ASSERT_NE(position, named.equations.end());
  EXPECT_LT(position->after.holdout_rms, 0.1 * position->before.holdout_rms);
}

}  // namespace
}  // namespace torquewright::rates
