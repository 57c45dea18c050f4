// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/signal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace torquewright::identification {
namespace {

constexpr double kRate_Hz = 500.0;

std::vector<double> sampled(std::size_t count, double (*value)(double), double step_s) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = value(static_cast<double>(i) * step_s);
  return values;
}

/// Amplitudes of a wave that is in step with sin(2 pi f t), and a quarter turn ahead of it, over
/// the middle half of the signal, where the ends have died away.
struct Wave {
  double in_step = 0.0, ahead = 0.0;
};
Wave wave_in(const std::vector<double>& signal, double frequency_Hz) {
  Wave wave;
  const std::size_t quarter = signal.size() / 4;
  for (std::size_t i = quarter; i < 3 * quarter; ++i) {
    const double phase = 2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / kRate_Hz;
    wave.in_step += signal[i] * std::sin(phase) / static_cast<double>(quarter);
    wave.ahead += signal[i] * std::cos(phase) / static_cast<double>(quarter);
  }
  return wave;
}

// Oracle: closed form. A bilinear Butterworth filter of second order has the gain
// 1 / sqrt(1 + (tan(pi f / r) / tan(pi fc / r))^4); run both ways its square, without phase.
TEST(LowPass, HasTheGainOfAButterworthFilterTwiceAndNoPhase) {
  const double cutoff_Hz = 8.0;
  for (const double frequency_Hz : {1.0, 4.0, 8.0, 12.0, 20.0}) {
    std::vector<double> signal(8000);  // Whole periods in the middle half.
    for (std::size_t i = 0; i < signal.size(); ++i) {
      signal[i] =
          std::sin(2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / kRate_Hz);
    }
    LowPass(cutoff_Hz, kRate_Hz).apply(signal);
    const double bent = std::tan(std::numbers::pi * frequency_Hz / kRate_Hz) /
                        std::tan(std::numbers::pi * cutoff_Hz / kRate_Hz);
    const Wave wave = wave_in(signal, frequency_Hz);
    // Round-off, and ends that have died away to exp(-2 pi fc t / sqrt 2), t = 4 s.
    EXPECT_NEAR(wave.in_step, 1.0 / (1.0 + std::pow(bent, 4)), 1e-9) << frequency_Hz;
    EXPECT_NEAR(wave.ahead, 0.0, 1e-9) << frequency_Hz;
    EXPECT_NEAR(LowPass(cutoff_Hz, kRate_Hz).gain(frequency_Hz), wave.in_step, 1e-9);
  }
}

TEST(LowPass, PassesEverythingNearHalfTheRate) {
  std::vector<double> signal = {1.0, -3.0, 2.0, 7.0, 0.5};
  const std::vector<double> before = signal;
  LowPass(0.46 * kRate_Hz, kRate_Hz).apply(signal);
  EXPECT_EQ(signal, before);
}

// Oracle: closed form. The inner formula has no error up to degree four, the ends' up to two.
TEST(Derivative, IsExactOnCubicsInsideAndOnParabolasAtTheEnds) {
  const double step_s = 0.01;
  const auto cubic = sampled(
      30, [](double t) { return 2.0 + t - 3.0 * t * t + 5.0 * t * t * t; }, step_s);
  const std::vector<double> slope = derivative(cubic, step_s);
  for (std::size_t i = 2; i < 28; ++i) {
    const double t = static_cast<double>(i) * step_s;
    EXPECT_NEAR(slope[i], 1.0 - 6.0 * t + 15.0 * t * t, 1e-12);  // Round-off: 1e-16 / 0.01 * 8.
  }
  const auto parabola = sampled(
      30, [](double t) { return 1.0 - 4.0 * t * t; }, step_s);
  const std::vector<double> ends = derivative(parabola, step_s);
  for (const std::size_t i : {0, 1, 28, 29}) {
    EXPECT_NEAR(ends[i], -8.0 * static_cast<double>(i) * step_s, 1e-12);
  }
}

/// Largest error inside of the derivative of sin(t) over 2 s.
double error_at(double step_s) {
  const auto count = static_cast<std::size_t>(std::lround(2.0 / step_s)) + 1;
  const auto signal = sampled(
      count, [](double t) { return std::sin(t); }, step_s);
  const std::vector<double> slope = derivative(signal, step_s);
  double worst = 0.0;
  for (std::size_t i = 2; i + 2 < count; ++i) {
    worst = std::max(worst, std::abs(slope[i] - std::cos(static_cast<double>(i) * step_s)));
  }
  return worst;
}

// Oracle: convergence order. The error term is h^4 / 30 times the fifth derivative.
TEST(Derivative, ConvergesWithTheFourthPowerOfTheStep) {
  EXPECT_NEAR(std::log2(error_at(0.1) / error_at(0.05)), 4.0, 0.05);
  EXPECT_NEAR(std::log2(error_at(0.05) / error_at(0.025)), 4.0, 0.05);
}

// Oracle: statistics. The median of |x| over n normal values has a relative standard error of
// 1.17 / sqrt(n) when they are independent; fifth differences of neighbours are not: at most six
// share a sample, so sqrt(11) bounds the growth. Five of those errors.
TEST(NoiseLevel, FindsWhiteNoiseOnASmoothSignal) {
  const std::size_t n = 200000;
  const double bound = 5.0 * 1.17 * std::sqrt(11.0 / static_cast<double>(n));
  for (const double level : {1e-4, 0.3}) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0.0, level);
    std::vector<double> signal(n);
    for (std::size_t i = 0; i < n; ++i) {
      // Fifth differences of a wave of 1 Hz at 500 Hz are (2 pi / 500)^5 = 3e-10 of it.
      signal[i] =
          std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / kRate_Hz) + noise(random);
    }
    EXPECT_NEAR(noise_level(signal) / level, 1.0, bound);
  }
}

// Oracle: closed form. Fifth differences of a polynomial of degree four are zero, of a wave small.
TEST(NoiseLevel, IsBlindToASmoothSignal) {
  const auto quartic = sampled(
      400, [](double t) { return t - t * t * t * t; }, 0.01);
  EXPECT_LT(noise_level(quartic), 1e-12);
  const auto wave = sampled(
      400, [](double t) { return std::sin(t); }, 0.01);
  EXPECT_LT(noise_level(wave), 1e-10);
  EXPECT_EQ(noise_level(std::vector<double>(15, 1.0)), 0.0);
}

// Oracle: closed form. Interpolation of a straight line is the line, whatever the grid.
TEST(Resampled, IsExactOnStraightLines) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> step(0.5e-3, 2e-3);
  std::vector<double> time_s = {0.2};
  while (time_s.size() < 300) time_s.push_back(time_s.back() + step(random));
  std::vector<double> line;
  for (const double t : time_s) line.push_back(3.0 - 2.0 * t);
  const std::vector<double> values = resampled_linearly(time_s, line, 0.21, 1e-3, 200);
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_NEAR(values[k], 3.0 - 2.0 * (0.21 + 1e-3 * static_cast<double>(k)), 1e-14);
  }
}

/// Times of a step of 10 ms that jitter by half a step either way, at the most.
std::vector<double> jittered_s(std::size_t count) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> jitter(-0.49, 0.49);
  std::vector<double> time_s;
  for (std::size_t i = 0; i < count; ++i) {
    time_s.push_back(0.01 * (static_cast<double>(i) + jitter(random)));
  }
  return time_s;
}

// Oracle: closed form. Fifth divided differences of a polynomial of degree four are zero at any
// times; those over the index are not.
TEST(NoiseLevel, IsBlindToASmoothSignalAtUnevenTimes) {
  const std::vector<double> time_s = jittered_s(400);
  std::vector<double> quartic;
  for (const double t : time_s) quartic.push_back(t - 0.3 * t * t * t * t);
  EXPECT_LT(noise_level(time_s, quartic), 1e-11);
  EXPECT_GT(noise_level(quartic), 1e-3);
}

// Oracle: the deviation put in. The median of 100 000 differences, neighbours among them alike, is
// known to about 1 %.
TEST(NoiseLevel, IsThatOfWhiteNoiseAtUnevenTimes) {
  const std::vector<double> time_s = jittered_s(100000);
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0.0, 0.2);
  std::vector<double> values;
  for (const double t : time_s) values.push_back(3.0 * std::sin(4.0 * t) + noise(random));
  EXPECT_NEAR(noise_level(time_s, values), 0.2, 0.006);
}

// Oracle: closed form. Through four samples of a cubic goes that cubic; next to an end it is a
// line.
TEST(Resampled, IsExactOnCubicsAtUnevenTimes) {
  const std::vector<double> time_s = jittered_s(300);
  const auto cubic = [](double t) { return 1.0 + t * (2.0 - t * (3.0 - t)); };
  std::vector<double> values;
  for (const double t : time_s) values.push_back(cubic(t));
  const std::vector<double> even = resampled(time_s, values, 0.05, 0.01, 280);
  for (std::size_t k = 0; k < even.size(); ++k) {
    EXPECT_NEAR(even[k], cubic(0.05 + 0.01 * static_cast<double>(k)), 1e-12) << k;
  }
}

// Oracle: white noise. Two samples next to one another say no slope: the cubic never makes more of
// noise than half as much again, where one through the next four would make ten times as much.
TEST(Resampled, MakesLittleOfNoiseWhereTimesCrowd) {
  std::vector<double> time_s;
  for (int i = 0; i < 4000; ++i) {
    time_s.push_back(0.01 * i);
    time_s.push_back(0.01 * i + 1e-4);
  }
  std::mt19937_64 random(6);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<double> values(time_s.size());
  for (double& value : values) value = noise(random);
  const std::vector<double> even = resampled(time_s, values, 0.105, 0.01, 3900);
  double square = 0.0;
  for (const double value : even) square += value * value;
  EXPECT_LT(std::sqrt(square / 3900.0), 1.5);
}

TEST(Advanced, MovesAStraightLineAndHoldsItsEnd) {
  const auto line = sampled(
      50, [](double t) { return 2.0 * t; }, 0.01);
  const std::vector<double> early = advanced(line, 0.025, 0.01);
  for (std::size_t i = 0; i < 47; ++i) {
    EXPECT_NEAR(early[i], 2.0 * (0.01 * static_cast<double>(i) + 0.025), 1e-14);
  }
  EXPECT_EQ(early.back(), line.back());
}

}  // namespace
}  // namespace torquewright::identification
