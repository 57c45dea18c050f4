// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/spectral_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "identification/answer/analysis.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::spectral_lines_test {
namespace {

using made::Made;
using made::MadeBench;

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr double kErrors = 4.0;  ///< Deviations of a statistic of fixed seeds.

/// Runs of a rotor at a rate, with noise and what a law of time and the rotor's angle adds.
struct Runs {
  std::size_t samples = 2400;
  double step_s = 0.005, sigma = 0.1;
  std::vector<std::function<double(double)>> turns;  ///< By run, of time.
  std::function<double(double, double)> law = [](double, double) { return 0.0; };

  std::vector<LineTrace> traces(std::uint64_t seed) const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.0, sigma);
    std::vector<LineTrace> all;
    for (const auto& turn : turns) {
      LineTrace trace;
      trace.run = "run_" + std::to_string(all.size());
      trace.step_s = step_s;
      for (std::size_t i = 0; i < samples; ++i) {
        const double t = step_s * static_cast<double>(i);
        trace.motor_rad.push_back(kTurn_rad * turn(t));
        trace.value.push_back(noise(random) + law(t, trace.motor_rad.back()));
        trace.usable.push_back(i % 400 >= 20);
        if (trace.usable.back() == 0) trace.value.back() = 1e3;  // Nobody's.
      }
      all.push_back(std::move(trace));
    }
    return all;
  }
};

/// Steady, and to and fro.
std::function<double(double)> even(double rate_Hz) {
  return [rate_Hz](double t) { return rate_Hz * t; };
}
std::function<double(double)> swinging(double t_turns) {
  return [t_turns](double t) { return t_turns * std::sin(1.3 * t); };
}

double hum(double amplitude, double frequency_Hz, double t) {
  return amplitude * std::sin(kTurn_rad * frequency_Hz * t + 0.4);
}

/// Of a sine's frequency in white noise, sqrt(6) sigma / (pi A T sqrt(n)), by Rife and Boorstyn
/// (1974); the window costs less than a factor of two.
double frequency_error_Hz(const Runs& runs, double amplitude) {
  const auto n = static_cast<double>(runs.samples);
  return 2.0 * std::sqrt(6.0) * runs.sigma /
         (std::numbers::pi * amplitude * n * runs.step_s * std::sqrt(n));
}

// Oracle: draws of exponential variables, as spectral values of white noise are.
TEST(SpectralLines, ChanceOfAPeakIsThatOfDraws) {
  constexpr int kDraws = 200000;
  std::mt19937_64 random(3);
  std::exponential_distribution<double> value;
  for (const int sides : {1, 2}) {
    int beyond = 0;
    for (int k = 0; k < kDraws; ++k) {
      double sum = 0.0;
      for (int side = 0; side < sides; ++side) {
        std::vector<double> around(8);
        for (double& each : around) each = value(random);
        std::sort(around.begin(), around.end());
        for (int i = 0; i < 6; ++i) sum += around[static_cast<std::size_t>(i)];
      }
      beyond += value(random) > sum;
    }
    const double chance = chance_of_peak(1.0, sides);
    EXPECT_NEAR(static_cast<double>(beyond) / kDraws, chance,
                kErrors * std::sqrt(chance * (1.0 - chance) / kDraws))
        << sides;
  }
}

int logs_with_a_line(const Runs& runs, int logs, const SpectralLineOptions& options) {
  int with_line = 0;
  for (int seed = 1; seed <= logs; ++seed) {
    with_line += !spectral_lines(runs.traces(static_cast<std::uint64_t>(seed)), options).empty();
  }
  return with_line;
}

// Oracle: the chance that is stated. Neighbouring bins of the window share 4/9 of their power, so
// that all of them are as many independent trials as there are, or half as many at least: noise
// alone shows a line in 20 of 100 logs at most, and in 1 - 0.8^(1/2) = 10.6 at least.
TEST(SpectralLines, OfNoiseAreAsRareAsStated) {
  constexpr int kLogs = 400;
  Runs runs;
  runs.samples = 1200;
  runs.turns = {even(2.0), swinging(1.0)};
  const int found = logs_with_a_line(runs, kLogs, {0.2, 8});
  EXPECT_LE(found, 0.2 * kLogs + kErrors * std::sqrt(0.2 * 0.8 * kLogs));
  EXPECT_GE(found, 0.106 * kLogs - kErrors * std::sqrt(0.106 * 0.894 * kLogs));
}

// The same at the chance in use, of 200 logs: more than seven come by 1 % with less than 0.1 %
// (binomial distribution).
TEST(SpectralLines, OfNoiseAreHardlyToldAtAll) {
  Runs runs;
  runs.turns = {even(2.0), swinging(1.0)};
  EXPECT_LE(logs_with_a_line(runs, 200, {}), 7);
}

TEST(SpectralLines, AHumComesOutAsItWasPutIn) {
  for (const double frequency_Hz : {16.85, 50.0, 97.0}) {
    Runs runs;
    runs.turns = {even(2.0), swinging(3.0)};
    runs.law = [=](double t, double) { return hum(0.06, frequency_Hz, t); };
    const auto lines = spectral_lines(runs.traces(7));
    ASSERT_EQ(lines.size(), 1u) << frequency_Hz;
    EXPECT_NEAR(lines[0].frequency_Hz, frequency_Hz, kErrors * frequency_error_Hz(runs, 0.06));
    EXPECT_NEAR(lines[0].amplitude, 0.06, kErrors * lines[0].amplitude_error);
    EXPECT_EQ(lines[0].keeps_to, LineKeepsTo::kTime);
    EXPECT_EQ(lines[0].runs, (std::vector<std::string>{"run_0", "run_1"}));
  }
}

// Oracle: the least error of an amplitude in white noise, sigma sqrt(2/n), times the root of 1.5
// that the window costs; 5 % of the samples are masked.
TEST(SpectralLines, AnAmplitudesErrorIsThatOfItsNoise) {
  Runs runs;
  runs.turns = {swinging(3.0)};
  runs.law = [](double t, double) { return hum(0.06, 31.3, t); };
  double sum = 0.0;
  constexpr int kLogs = 50;
  for (std::uint64_t seed = 1; seed <= kLogs; ++seed)
    sum += spectral_lines(runs.traces(seed)).at(0).amplitude_error / kLogs;
  const double least = runs.sigma * std::sqrt(2.0 / (0.95 * static_cast<double>(runs.samples)));
  // Twelve neighbours tell a power to 29 %, an amplitude to 14 %: of the mean of fifty 2 %.
  EXPECT_NEAR(sum / (std::sqrt(1.5) * least), 1.0, kErrors * 0.02);
}

TEST(SpectralLines, AnOrderKeepsToTheRotor) {
  Runs runs;
  runs.turns = {even(2.0), even(2.9), even(4.3)};
  runs.law = [](double, double motor_rad) { return 0.06 * std::sin(7.0 * motor_rad + 1.0); };
  const auto lines = spectral_lines(runs.traces(7));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].keeps_to, LineKeepsTo::kRotor);
  EXPECT_NEAR(lines[0].order, 7.0, kErrors * frequency_error_Hz(runs, 0.06) / 2.0);
  EXPECT_NEAR(lines[0].amplitude, 0.06, kErrors * lines[0].amplitude_error);
  EXPECT_EQ(lines[0].runs.size(), 3u);
}

// One run at an even rate shows an order and a hum alike.
TEST(SpectralLines, AnEvenRateDoesNotTell) {
  Runs runs;
  runs.turns = {even(2.0)};
  runs.law = [](double t, double) { return hum(0.06, 31.3, t); };
  const auto lines = spectral_lines(runs.traces(7));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].keeps_to, LineKeepsTo::kEither);
  EXPECT_NEAR(lines[0].order, 31.3 / 2.0, 0.01);
}

TEST(SpectralLines, WithinTheMotionsMultiplesALawMaySoundToo) {
  Runs runs;
  runs.turns = {swinging(3.0)};
  runs.law = [](double t, double) { return hum(0.06, 16.85, t); };
  std::vector<LineTrace> traces = runs.traces(7);
  for (const auto& [motion_Hz, keeps_to] :
       {std::pair{16.8 / 9.0, LineKeepsTo::kTime}, std::pair{16.9 / 9.0, LineKeepsTo::kMotion}}) {
    traces[0].motion_Hz = motion_Hz;
    EXPECT_EQ(spectral_lines(traces).at(0).keeps_to, keeps_to) << motion_Hz;
  }
}

// Oracle: closed form. A sine of 1.2 Hz beside a smaller one of 0.3 Hz; most of the power is there.
TEST(SpectralLines, TheEdgeIsWhereThePowerEnds) {
  std::vector<double> steady(2400, 3.0), moved;
  for (int i = 0; i < 2400; ++i)
    moved.push_back(std::sin(kTurn_rad * 1.2 * 0.005 * i) +
                    0.5 * std::sin(kTurn_rad * 0.3 * 0.005 * i));
  EXPECT_EQ(edge_Hz(steady, 0.005), 0.0);
  EXPECT_NEAR(edge_Hz(moved, 0.005), 1.2, 2.0 / 12.0);
}

/// Lines of the sensor's equation of a made log.
std::vector<SpectralLine> lines_of(const std::function<double(const Made&)>& law) {
  const MadeBench made;
  const Log log = made.log(law, 0.1);
  AnalysisOptions options;
  options.select = false;
  return analyse(made.rig, log, 0, {&made.actuator}, options).at(0).lines;
}

// A log of 200 Hz whose model is true, with a hum within and above the signals' band of 25 Hz.
TEST(SpectralLines, OfALogReachUpToHalfItsRate) {
  for (const double frequency_Hz : {16.85, 77.0}) {
    const auto lines =
        lines_of([=](const Made& now) { return hum(0.05, frequency_Hz, now.time_s); });
    ASSERT_EQ(lines.size(), 1u) << frequency_Hz;
    EXPECT_NEAR(lines[0].frequency_Hz, frequency_Hz, 0.01);
    EXPECT_NEAR(lines[0].amplitude, 0.05, kErrors * lines[0].amplitude_error);
    EXPECT_EQ(lines[0].keeps_to, LineKeepsTo::kTime);
  }
  EXPECT_TRUE(lines_of([](const Made&) { return 0.0; }).empty());
}

}  // namespace
}  // namespace torquewright::identification::spectral_lines_test
