// SPDX-License-Identifier: Apache-2.0
// Oracle: motions in closed form, position and its exact rate, one of them spoilt.
#include "actuator/check/travel_agreement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace torquewright::actuator {
namespace {

using Function = std::function<double(double)>;

constexpr double kNoLoad_rad_s = 10.0;
constexpr double kTurn = 2.0 * std::numbers::pi;

double still(double) { return 0.0; }
/// Half a radian to and fro, twice a second.
double swing(double t) { return 0.5 * std::sin(2.0 * kTurn * t); }
double swing_rate(double t) { return kTurn * std::cos(2.0 * kTurn * t); }

TravelAgreement over(double duration_s, int steps, const Function& position,
                     const Function& velocity) {
  TravelAgreement travels;
  for (int i = 0; i <= steps; ++i) {
    const double t = duration_s * i / steps;
    travels.add(t, position(t), velocity(t));
  }
  return travels;
}

bool contradicts(const TravelAgreement& travels) {
  return travels.contradiction(kNoLoad_rad_s).has_value();
}

bool contradicts(const Function& position, const Function& velocity) {
  return contradicts(over(4.0, 4000, position, velocity));
}

TEST(TravelAgreement, FindsAColumnThatIsDeadConstantLateOrAnothers) {
  EXPECT_FALSE(contradicts(swing, swing_rate));
  EXPECT_TRUE(contradicts(swing, still));
  EXPECT_TRUE(contradicts(still, swing_rate));
  EXPECT_TRUE(contradicts(swing, [](double) { return 3.0; }));
  // A quarter of a swing late; over its eight whole swings both integrals vanish.
  EXPECT_TRUE(contradicts(swing, [](double t) { return swing_rate(t - 0.125); }));
  EXPECT_TRUE(contradicts(swing, [](double t) { return kTurn * std::cos(kTurn * t); }));
  EXPECT_FALSE(contradicts(still, still));
}

TEST(TravelAgreement, SaysFromWhereToWhere) {
  const auto found = over(
                         1.0, 100, [](double t) { return 2.0 - 3.0 * t; }, still)
                         .contradiction(kNoLoad_rad_s);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->from_s, 0.0, 0.011);  // a row: what is near an end rests there
  EXPECT_NEAR(found->until_s, 1.0, 0.011);
  EXPECT_NEAR(found->position_change_rad, -3.0 * (found->until_s - found->from_s), 1e-12);
  EXPECT_EQ(found->velocity_integral_rad, 0.0);
}

// Of a velocity that is a part of the rate, the rest is left over: just within 0.3, and beyond.
TEST(TravelAgreement, LeavesThreeTenths) {
  const auto part = [](double share) {
    return [share](double t) { return share * swing_rate(t); };
  };
  EXPECT_FALSE(contradicts(swing, part(0.71)));
  EXPECT_TRUE(contradicts(swing, part(0.67)));
}

// Encoders of 2 mrad at 1 kHz: slopes are off by 2 rad/s from row to row, and agree over more rows.
TEST(TravelAgreement, ForgivesRoundedPositionsAndNoisyVelocities) {
  const auto rounded = [](double t) { return 2e-3 * std::round(swing(t) / 2e-3); };
  EXPECT_FALSE(contradicts(rounded, swing_rate));
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0.0, 1.0);
  const auto noisy = [&](double t) { return swing_rate(t) + noise(generator); };
  EXPECT_FALSE(contradicts(swing, noisy));
  // A joint that holds still: neither its encoder's last digit nor its velocity's noise is a
  // motion.
  const auto flickering = [&](double) { return noise(generator) > 0.0 ? 2e-3 : 0.0; };
  EXPECT_FALSE(contradicts(flickering, still));
  EXPECT_FALSE(contradicts(still, [&](double) { return 0.3 * noise(generator); }));
}

// A low pass of 5 ms lags by 0.06 rad of this swing.
TEST(TravelAgreement, ForgivesAFilter) {
  EXPECT_FALSE(contradicts(swing, [](double t) { return swing_rate(t - 5e-3); }));
}

// By hand: a ramp of 0.11 rad/s is 1.1 % of the no-load speed, one of 0.09 is 0.9 %.
TEST(TravelAgreement, ForgivesWhatIsTooSlowToMatter) {
  EXPECT_FALSE(contradicts([](double t) { return 0.09 * t; }, still));
  EXPECT_TRUE(contradicts([](double t) { return 0.11 * t; }, still));
}

// Quick, but within the 0.02 rad that play and rounding may hide; and beyond, for a hundred swings.
TEST(TravelAgreement, ForgivesWhatIsTooShortToBeSeen) {
  const auto shaking = [](double range_rad) {
    return [range_rad](double t) { return 0.5 * range_rad * std::sin(25.0 * kTurn * t); };
  };
  EXPECT_FALSE(contradicts(shaking(0.019), still));
  EXPECT_TRUE(contradicts(shaking(0.03), still));
}

// An estimator's bias of a thirtieth of the swing's speed adds up over many swings.
TEST(TravelAgreement, ForgivesASmallBias) {
  EXPECT_FALSE(
      contradicts(over(100.0, 100000, swing, [](double t) { return swing_rate(t) + 0.2; })));
  EXPECT_TRUE(contradicts(over(100.0, 100000, swing, still)));
}

// Key frames from rest to rest are no contradiction: too few rows.
TEST(TravelAgreement, NeedsEightSteps) {
  const auto ramp = [](double t) { return t; };
  EXPECT_FALSE(contradicts(over(1.0, 7, ramp, still)));
  EXPECT_TRUE(contradicts(over(1.0, 8, ramp, still)));
}

// What disagrees is neither outweighed by what agrees nor thinned out by rest: a fifth of a walk,
// and one jump in five minutes.
TEST(TravelAgreement, FindsAPartOfAMotion) {
  const auto until = [](double end_s, const Function& rate) {
    return [end_s, rate](double t) { return t < end_s ? rate(t) : 0.0; };
  };
  EXPECT_FALSE(contradicts(over(10.0, 10000, swing, swing_rate)));
  EXPECT_TRUE(contradicts(over(10.0, 10000, swing, until(8.0, swing_rate))));
  const auto jump = [](double t) { return t < 290.0 ? 0.0 : 0.4 * (1.0 - std::cos(8.0 * t)); };
  EXPECT_TRUE(contradicts(over(300.0, 60000, jump, still)));
}

// A single swing of less than the greatest may be flexing that only one of the sensors sees.
TEST(TravelAgreement, ForgivesLessThanTheGreatestHalfSwing) {
  const auto flexing = [](double t) {
    return swing(t) + (t > 2.0 && t < 2.1 ? 0.1 * std::sin(5.0 * kTurn * (t - 2.0)) : 0.0);
  };
  EXPECT_FALSE(contradicts(flexing, swing_rate));
}

// Readings of the position that are wrong, with a joint that stands: one at a time, noise of 5
// mrad, and an encoder of eight bits between two of its levels.
TEST(TravelAgreement, ForgivesPositionsThatAreWrongWhileNothingMoves) {
  std::mt19937 generator(2);
  std::normal_distribution<double> noise(0.0, 1.0);
  const auto glitch = [](double t) { return std::abs(t - 2.0) < 5e-4 ? 0.3 : 0.0; };
  EXPECT_FALSE(contradicts(glitch, still));
  const auto noisy = [&](double) { return 5e-3 * noise(generator); };
  EXPECT_FALSE(contradicts(noisy, still));
  const auto coarse = [&](double) { return noise(generator) > 1.0 ? kTurn / 256.0 : 0.0; };
  EXPECT_FALSE(contradicts(coarse, still));
}

// By hand: late by a phase of p the integral over a half swing is cos p of it, whatever the rate of
// the log; 0.7 is that of 45.6 degrees.
TEST(TravelAgreement, ForgivesFortyFiveDegreesAtAnyRate) {
  const auto late = [](double degrees) {
    return [degrees](double t) { return swing_rate(t - 0.5 * degrees / 360.0); };
  };
  for (const int rows : {400, 1000, 4000, 5120}) {
    EXPECT_FALSE(contradicts(over(4.0, rows, swing, late(42.0)))) << rows;
    EXPECT_TRUE(contradicts(over(4.0, rows, swing, late(52.0)))) << rows;
  }
}

// Nobody knows what the joint did while nothing was recorded.
TEST(TravelAgreement, LeavesGapsOut) {
  TravelAgreement travels;
  for (int i = 0; i <= 100; ++i) travels.add(1e-3 * i, 0.0, 0.0);
  for (int i = 0; i <= 100; ++i) travels.add(5.0 + 1e-3 * i, 20.0, 0.0);
  EXPECT_FALSE(contradicts(travels));
}

}  // namespace
}  // namespace torquewright::actuator
