// SPDX-License-Identifier: Apache-2.0
// Logs in which nothing is missing. Oracle: closed forms of what the documents state, and the noise
// that was put on them: a verdict other than that nothing is missing is a false alarm.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "actuator/effects/library.hpp"
#include "actuator/motor/actuator.hpp"
#include "identification/answer/analysis.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::clean_logs_test {
namespace {

using made::Made;
using made::MadeBench;

constexpr double kNoise_Nm = 0.01, kAlmostNone_Nm = 1e-6;
constexpr std::uint64_t kSeeds[] = {1, 2, 3, 4};

void expect_nothing_missing(const MadeBench& made, const Log& log, std::uint64_t seed) {
  const EquationResult result = analyse(made.rig, log, 0, {&made.actuator}, {}).front();
  EXPECT_EQ(result.verdict, Verdict::kNothingMissing)
      << seed << ": " << result.after.train_rms << " and " << result.after.holdout_rms << " of "
      << result.noise_floor_rms;
  for (const NamedEffect& each : result.added) ADD_FAILURE() << seed << ": " << each.effect;
}

TEST(CleanLogs, OfAStatedLoadFrictionAndStribeckMissNothing) {
  constexpr double kCoulomb_Nm = 0.3, kBreakaway_Nm = 0.5, kSlow_rad_s = 0.4;
  constexpr double kDriving = 0.15, kBackdriving = 0.1;
  MadeBench made;
  made.actuator.effects.push_back({actuator::find_effect("stribeck_friction"),
                                   {kCoulomb_Nm, kBreakaway_Nm, kSlow_rad_s},
                                   {},
                                   false,
                                   "stated"});
  made.actuator.effects.push_back({actuator::find_effect("load_dependent_friction"),
                                   {kDriving, kBackdriving},
                                   {},
                                   false,
                                   "stated"});
  for (const std::uint64_t seed : kSeeds) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise_Nm(0.0, kNoise_Nm);
    const Log log = made.log(
        [&](const Made& at) {
          const double way = made::sign(at.speed_rad_s), over = at.speed_rad_s / kSlow_rad_s;
          const double level_Nm =
              kCoulomb_Nm + (kBreakaway_Nm - kCoulomb_Nm) * std::exp(-over * over);
          const double meshed_Nm = at.torque_Nm - level_Nm * way;
          const double at_load_Nm =
              meshed_Nm / (meshed_Nm * way > 0.0 ? 1.0 + kDriving : 1.0 - kBackdriving);
          return at_load_Nm - at.torque_Nm + noise_Nm(random);
        },
        kAlmostNone_Nm);
    expect_nothing_missing(made, log, seed);
  }
}

// A sensor's noise behind its own filter of first order: of the samples' differences it shows a
// part, in the band nearly all.
TEST(CleanLogs, OfATorqueSensorThatFiltersMissNothing) {
  constexpr double kSampling_s = 0.005;
  const MadeBench made;
  for (const double filter_Hz : {40.0, 20.0, 10.0}) {
    const double follow = -std::expm1(-2.0 * std::numbers::pi * filter_Hz * kSampling_s);
    for (const std::uint64_t seed : kSeeds) {
      std::mt19937_64 random(seed);
      std::normal_distribution<double> noise_Nm(0.0, kNoise_Nm);
      double shown_Nm = 0.0;
      const Log log =
          made.log([&](const Made&) { return shown_Nm += follow * (noise_Nm(random) - shown_Nm); },
                   kAlmostNone_Nm);
      expect_nothing_missing(made, log, seed);
    }
  }
}

}  // namespace
}  // namespace torquewright::identification::clean_logs_test
