// SPDX-License-Identifier: Apache-2.0
// Oracle: motions in closed form, whose reversals are known.
#include "identification/signals/direction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "identification/signals/signal.hpp"
#include "identification/signals/thinning.hpp"

namespace torquewright::identification {
namespace {

constexpr double kStep_s = 0.002;
constexpr double kCutoff_Hz = 25.0;

/// Position of a velocity that bends at its reversal: `before` up to then, `after` from then on.
std::vector<double> bent(double reversal_s, double before_rad_s2, double after_rad_s2) {
  std::vector<double> position_rad;
  for (int i = 0; i < 1000; ++i) {
    const double t = i * kStep_s - reversal_s;
    position_rad.push_back(0.5 * (t < 0.0 ? before_rad_s2 : after_rad_s2) * t * t);
  }
  return position_rad;
}

std::vector<double> directions_of(const std::vector<double>& position_rad, double deviation_rad,
                                  bool is_position_known) {
  std::vector<double> low = position_rad;
  LowPass(kCutoff_Hz, 1.0 / kStep_s).apply(low);
  const RawMotion raw{is_position_known ? position_rad : std::vector<double>(), false,
                      deviation_rad, kStep_s};
  return directions(derivative(low, kStep_s), raw, kCutoff_Hz);
}

/// When it went from -1 to 1: the integral of a step from -1 to 1 is T - 2 (reversal).
double reversal_s(const std::vector<double>& direction) {
  double sum = 0.0;
  for (const double each : direction) sum += each;
  const double end_s = (static_cast<double>(direction.size()) - 0.5) * kStep_s;
  return end_s - 0.5 * (sum * kStep_s + end_s + 0.5 * kStep_s);
}

TEST(Directions, TurnWithinASampleWhereTheVelocityIsStraight) {
  for (const double at_s : {1.0, 1.0004, 1.0013}) {
    const auto direction = directions_of(bent(at_s, 10.0, 10.0), 0.0, false);
    // A parabola passes the filter and the derivative as it is: round-off, and the filter's ends.
    EXPECT_NEAR(reversal_s(direction), at_s, 1e-5);
  }
}

// A low-pass moves the reversal by about (a2 - a1)/(a2 + a1) times its kernel's mean reach, some
// 5 ms at 25 Hz; in eight times the band, where no noise forbids it, less than the quarter that
// four times leave (samples of 2 ms add to an eighth). Where noise hides it the narrow band
// decides.
TEST(Directions, TurnInTheWidestBandThatShowsIt) {
  const std::vector<double> position_rad = bent(1.0, 2.0, 30.0);
  const auto error_s = [&](double deviation_rad, bool is_position_known) {
    return std::abs(reversal_s(directions_of(position_rad, deviation_rad, is_position_known)) -
                    1.0);
  };
  const double filtered_s = error_s(0.0, false);
  EXPECT_GT(filtered_s, 1.5e-3);
  EXPECT_LT(error_s(0.0, true), 0.25 * filtered_s);
  EXPECT_NEAR(error_s(1e-3, true), error_s(1e-3, false), 1e-5);
}

// Noise hides the sign in a band of 100 Hz for some milliseconds of such a reversal, and between
// two signs that it shows the band itself says when: with a quarter of the error of 25 Hz by the
// bend, and what its noise, 0.007 rad/s, makes of the time at the slower of both accelerations. A
// narrower band would be wrong by half of that error at the least.
TEST(Directions, TurnByTheWidestBandBetweenNearSignsThatAreKnown) {
  constexpr double kDeviation_rad = 3e-5, kSlower_rad_s2 = 5.0, kNoise_rad_s = 0.007;
  const std::vector<double> clean_rad = bent(1.0, kSlower_rad_s2, 30.0);
  const double filtered_s = std::abs(reversal_s(directions_of(clean_rad, 0.0, false)) - 1.0);
  const double expected_s = std::hypot(0.25 * filtered_s, kNoise_rad_s / kSlower_rad_s2);
  ASSERT_LT(expected_s, 0.5 * filtered_s);
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, kDeviation_rad);
  constexpr int kDraws = 40;
  double square = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<double> noisy_rad = clean_rad;
    for (double& each : noisy_rad) each += noise(random);
    const double error_s = reversal_s(directions_of(noisy_rad, kDeviation_rad, true)) - 1.0;
    square += error_s * error_s / kDraws;
  }
  EXPECT_LT(std::sqrt(square), expected_s);
}

TEST(Directions, AreNoneAtRest) {
  for (const double each : directions_of(std::vector<double>(1000, 0.3), 1e-4, true)) {
    EXPECT_NEAR(each, 0.0, 1e-9);
  }
}

// Oracle: the integral over time, which a mean over each sample keeps.
TEST(Thinned, DirectionsKeepTheTimeOfAReversal) {
  for (const std::size_t factor : {4U, 5U}) {
    for (std::size_t reversal = 500; reversal < 510; ++reversal) {
      Signals signals;
      signals.step_s = kStep_s;
      signals.at.resize(1000);
      signals.time_s.resize(1000);
      double sum = 0.0;
      for (std::size_t i = 0; i < 1000; ++i) {
        signals.at[i].direction = i < reversal ? -1.0 : 1.0;
      }
      thin(signals, factor);
      for (const auto& at : signals.at) sum += at.direction * static_cast<double>(factor);
      // Samples stand for what lies around them: the first for half of its own before the log.
      const double first = 0.5 * static_cast<double>(factor) - 0.5;
      const double forward = 1000.0 - static_cast<double>(reversal);
      EXPECT_NEAR(sum, forward - static_cast<double>(reversal) - 2.0 * first, 1e-9)
          << factor << ' ' << reversal;
    }
  }
}

// White noise leaves d/dt q below a cut-off of 2 pi cutoff sigma/sqrt 3 times the root of the share
// of the band: at 100 Hz and 5 mrad four deviations are 1.28 rad/s below 25 Hz, 0.45 below 12.5,
// 0.16 below 6.25; a sine of 1 rad/s exceeds 0.997 rad/s in 5 % of the time.
TEST(SeenSpeed, IsThatOfTheWidestBandInWhichTheMotionStandsOut) {
  constexpr double kLogged_s = 0.01, kOmega_rad_s = 0.6;
  const auto seen_Hz = [](double deviation_rad) {
    std::vector<double> position_rad;
    for (int i = 0; i < 6000; ++i)
      position_rad.push_back(std::sin(kOmega_rad_s * i * kLogged_s) / kOmega_rad_s);
    return RawMotion{position_rad, false, deviation_rad, kLogged_s}.seen_below_Hz(kCutoff_Hz);
  };
  EXPECT_EQ(seen_Hz(0.5e-3), kCutoff_Hz);
  EXPECT_EQ(seen_Hz(2e-3), kCutoff_Hz / 2.0);
  EXPECT_EQ(seen_Hz(5e-3), kCutoff_Hz / 4.0);
  EXPECT_EQ(seen_Hz(5.0), kCutoff_Hz) << "nothing stands out: nothing is gained by a narrower band";
}

}  // namespace
}  // namespace torquewright::identification
