// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/channel_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "identification/answer/analysis.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification {
namespace {

constexpr double kSampling_s = 0.005;
constexpr std::size_t kSampleCount = 2400;

/// One run of one channel by a law of time.
Log log_of(Quantity quantity, const std::function<double(double)>& of_time) {
  Run run;
  run.name = "run";
  run.joints.resize(1);
  for (std::size_t i = 0; i < kSampleCount; ++i) {
    run.time_s.push_back(kSampling_s * static_cast<double>(i));
    run.joints[0][quantity].push_back(of_time(run.time_s.back()));
  }
  run.masked.assign(kSampleCount, 0);
  Log log;
  log.runs.push_back(std::move(run));
  return log;
}

double level(const Log& log, Quantity quantity) {
  return noise_levels(log, 0)[static_cast<std::size_t>(quantity)];
}

double rounded(double value, double step) { return step * std::round(value / step); }

/// 0 and 7 by turns, 2 s each: a step test.
double steps(double t) { return std::fmod(t, 4.0) < 2.0 ? 0.0 : 7.0; }

// Oracle: closed form. A set-point that is held has no noise, whatever its steps are.
TEST(ChannelNoise, OfACommandIsNone) {
  for (const Quantity command : {Quantity::kDuty, Quantity::kCommandedTorque,
                                 Quantity::kCommandedPosition, Quantity::kWindingVoltage}) {
    EXPECT_EQ(level(log_of(command, steps), command), 0.0) << name_of(command);
  }
  // Many levels, each held: a ramp in steps.
  const auto ramp = [](double t) { return rounded(t, 0.25); };
  EXPECT_EQ(level(log_of(Quantity::kWindingVoltage, ramp), Quantity::kWindingVoltage), 0.0);
  std::mt19937_64 random(3);
  std::normal_distribution<double> jitter(0.0, 0.1);
  const auto controlled = [&](double) { return jitter(random); };
  EXPECT_EQ(level(log_of(Quantity::kDuty, controlled), Quantity::kDuty), 0.0);
}

// A set current that is logged as the current: its two levels are no resolution. What is left is
// single precision.
TEST(ChannelNoise, OfAFewLevelsIsNotTheirDistance) {
  const double found = level(log_of(Quantity::kMotorCurrent, steps), Quantity::kMotorCurrent);
  EXPECT_NEAR(found, 7.0 * std::ldexp(1.0, -23) / std::sqrt(12.0), 1e-15);
}

// Oracle: closed form. An error that is even over one step has its width over sqrt(12).
TEST(ChannelNoise, OfAQuantisedMeasurementIsItsStep) {
  for (const double step : {0.004, 0.05}) {
    const auto wave = [step](double t) { return rounded(std::sin(0.7 * t), step); };
    const Log log = log_of(Quantity::kOutputPosition, wave);
    EXPECT_GE(level(log, Quantity::kOutputPosition), step / std::sqrt(12.0) * (1.0 - 1e-9));
    EXPECT_LE(level(log, Quantity::kOutputPosition), step);
  }
  // At rest first, then smooth: nothing is quantised.
  const auto smooth = [](double t) { return t < 2.0 ? 0.0 : std::sin(0.7 * (t - 2.0)); };
  EXPECT_LT(level(log_of(Quantity::kOutputPosition, smooth), Quantity::kOutputPosition), 1e-6);
}

// Oracle: closed form, of the last digit.
TEST(ChannelNoise, IsNoLessThanTheLastDigit) {
  const auto wave = [](double t) { return std::sin(0.7 * t); };
  Log log = log_of(Quantity::kOutputVelocity, wave);
  log.printed.resize(1);
  log.printed[0][static_cast<std::size_t>(Quantity::kOutputVelocity)] = 1e-3;
  EXPECT_DOUBLE_EQ(level(log, Quantity::kOutputVelocity), 1e-3 / std::sqrt(12.0));
  Log command = log_of(Quantity::kDuty, wave);
  command.printed = log.printed;
  command.printed[0][static_cast<std::size_t>(Quantity::kDuty)] = 0.01;
  EXPECT_DOUBLE_EQ(level(command, Quantity::kDuty), 0.01 / std::sqrt(12.0));
}

// A log by closed forms, without noise: what filters leave at the ends of runs (some 1e-7 rad/s of
// 5) is no finding.
TEST(ChannelNoise, LeavesNothingToExplainInALogWithout) {
  made::MadeBench made;
  Log log = made.log([](const made::Made&) { return 0.0; }, 1e-9);
  for (std::size_t r = 0; r < log.runs.size(); ++r) {
    log.runs.change(r, [&](identification::Run& run) {
      for (const double t : run.time_s) {
        run.joints[0][Quantity::kOutputVelocity].push_back(
            std::round(1e8 * made::MadeBench::speed_rad_s(r, t)) * 1e-8);
      }
    });
  }
  for (const EquationResult& result : analyse(made.rig, log, 0, {&made.actuator}, {})) {
    EXPECT_EQ(result.verdict, Verdict::kNothingMissing) << result.quantity;
  }
}

}  // namespace
}  // namespace torquewright::identification
