// SPDX-License-Identifier: Apache-2.0
// Oracle: logs by closed form that hold something which no effect of the library is. No name is the
// only right answer.
#include <gtest/gtest.h>

#include <numbers>

#include "identification/answer/analysis.hpp"
#include "identification/answer/parameters_json.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::outside_the_library_test {
namespace {

using made::Made;
using made::MadeBench;
using made::sign;

EquationResult torque_of(const Log& log) {
  const MadeBench made;
  return analyse(made.rig, log, 0, {&made.actuator}, {}).front();
}

/// 0 to 1, a third of a turn wide, once a turn.
double bump(double angle_rad) {
  const double half = std::cos(0.5 * (angle_rad - 1.0));
  return std::pow(half, 16);
}

TEST(OutsideTheLibrary, FrictionOfOneSpotIsNoWaveOfFriction) {
  const MadeBench made;
  const EquationResult result = torque_of(made.log(
      [](const Made& at) { return -sign(at.speed_rad_s) * (0.2 + 0.8 * bump(at.angle_rad)); }));
  for (const NamedEffect& each : result.added) {
    EXPECT_NE(each.effect, "position_dependent_friction") << parameters_json(each.parameters);
  }
}

TEST(OutsideTheLibrary, TwoWavesOfFrictionAreNamed) {
  const MadeBench made;
  const EquationResult result = torque_of(made.log([](const Made& at) {
    return -sign(at.speed_rad_s) *
           (0.8 + 0.3 * std::sin(at.angle_rad) + 0.2 * std::sin(2.0 * at.angle_rad + 1.0));
  }));
  std::vector<std::string> names;
  for (const NamedEffect& each : result.added) names.push_back(each.effect);
  EXPECT_EQ(names, (std::vector<std::string>{"coulomb_friction", "position_dependent_friction"}));
}

/// Friction of one speed: where it is, a law of the library explains much of it, and a table more.
TEST(OutsideTheLibrary, FrictionOfOneSpeedIsNoFrictionOfTheLibrary) {
  const MadeBench made;
  const EquationResult result = torque_of(made.log([](const Made& at) {
    const double off = (std::abs(at.speed_rad_s) - 2.0) / 0.6;
    return -sign(at.speed_rad_s) * std::exp(-off * off);
  }));
  EXPECT_TRUE(result.added.empty()) << result.added.front().effect;
  ASSERT_FALSE(result.structure_before.empty());
  EXPECT_EQ(result.structure_before.front().coordinate, "output_velocity_rad_s");
}

/// A spring that stiffens by the cube of its angle: stops and waves may come near it, and a
/// polynomial of as many numbers is what it is.
TEST(OutsideTheLibrary, AStiffeningSpringIsNoStopsOrWavesForSure) {
  const EquationResult result = torque_of(
      made::MadeBench().log([](const Made& at) { return -0.05 * std::pow(at.angle_rad, 3); }));
  EXPECT_NE(result.verdict, Verdict::kExplained);
  for (const NamedEffect& each : result.added) {
    EXPECT_FALSE(is_certain(result, each.effect))
        << each.effect << " " << parameters_json(each.parameters);
  }
}

/// A spring and a wave of it, beside friction by the clock, which no curve of the position is.
TEST(OutsideTheLibrary, ASpringAndAWaveStaySureBesideWhatIsNoneOfThePosition) {
  const EquationResult result = torque_of(MadeBench().log([](const Made& at) {
    return -0.8 * at.angle_rad + 0.5 * std::sin(3.0 * at.angle_rad) -
           0.02 * sign(at.speed_rad_s) * at.time_s;
  }));
  for (const char* effect : {"parallel_spring", "gear_ripple"}) {
    EXPECT_TRUE(is_certain(result, effect)) << effect;
  }
}

/// Friction that grows by the clock: at no speed, load or angle is it what it is.
TEST(OutsideTheLibrary, FrictionThatGrowsWithTimeIsNoFrictionOfTheLibrary) {
  const MadeBench made;
  const EquationResult result =
      torque_of(made.log([](const Made& at) { return -sign(at.speed_rad_s) * 0.08 * at.time_s; }));
  EXPECT_TRUE(result.added.empty()) << result.added.front().effect;
  EXPECT_EQ(result.verdict, Verdict::kUnexplained);
  ASSERT_FALSE(result.structure_before.empty());
  EXPECT_EQ(result.structure_before.front().coordinate, "time_s");
}

/// Waves of friction in the three fitted runs, of another phase in the one that no fit sees.
TEST(OutsideTheLibrary, WhatOnlyHoldsWhereItWasFittedIsNotNamed) {
  const MadeBench made;
  const auto of_phase = [](double phase_rad) {
    return [phase_rad](const Made& at) { return 0.5 * std::sin(3.0 * at.angle_rad + phase_rad); };
  };
  Log log = made.log(of_phase(0.0));
  const Log other = made.log(of_phase(std::numbers::pi));
  log.runs.change(MadeBench::kRuns - 1,
                  [&](identification::Run& run) { run = other.runs[MadeBench::kRuns - 1]; });
  const EquationResult result = torque_of(log);
  EXPECT_TRUE(result.added.empty()) << result.added.front().effect;
}

}  // namespace
}  // namespace torquewright::identification::outside_the_library_test
