// SPDX-License-Identifier: Apache-2.0
// What is signal must not be repaired: sweeps of honest shapes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "identification/reading/isolated.hpp"
#include "identification/reading/saturation.hpp"
#include "identification/reading/wrap.hpp"

namespace torquewright::identification {
namespace {

constexpr double kStraightAngle = std::numbers::pi;

template <typename Shape>
std::vector<double> sampled(std::size_t count, const Shape& shape) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(shape(static_cast<double>(i)));
  return values;
}

double rounded(double value, double step) {
  return step > 0.0 ? step * std::round(value / step) : value;
}

// The dwell at the top of a rounded sine was derived in saturation.cpp: at most 4.8 times that of
// the step below it.
TEST(Saturation, IsNotSeenInRoundedSines) {
  for (const double period : {20.0, 57.3, 200.0, 777.7, 3000.0}) {
    for (const double step : {0.0, 0.001, 0.01, 0.1, 0.3}) {
      for (const double phase : {0.0, 0.4, 1.1}) {
        const auto values = sampled(6000, [&](double i) {
          return rounded(std::sin(2 * kStraightAngle * i / period + phase), step);
        });
        EXPECT_TRUE(find_saturated_values(values).empty()) << period << " " << step;
      }
    }
  }
}

TEST(Saturation, IsNotSeenInStaircasesAndSquareWaves) {
  EXPECT_TRUE(find_saturated_values(sampled(6000, [](double i) {
                return static_cast<double>(static_cast<int>(i / 500.0) % 5) - 2.0;
              })).empty());
  EXPECT_TRUE(find_saturated_values(sampled(6000, [](double i) {
                return static_cast<int>(i / 500.0) % 2 == 0 ? 1.0 : -1.0;
              })).empty());
}

TEST(Saturation, IsNotSeenAtRest) {
  EXPECT_TRUE(find_saturated_values(sampled(6000, [](double i) {
                return i < 3000.0 ? 0.0 : 1.0 - std::cos(i / 50.0);
              })).empty());
}

TEST(Saturation, IsSeenInClippedSinesWithAndWithoutNoise) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.02);
  for (const double period : {60.0, 200.0, 777.7}) {
    for (const bool noisy : {false, true}) {
      const auto values = sampled(6000, [&](double i) {
        return std::min(0.7,
                        std::sin(2 * kStraightAngle * i / period) + (noisy ? noise(random) : 0.0));
      });
      EXPECT_EQ(find_saturated_values(values), std::vector<double>{0.7}) << period << noisy;
    }
  }
}

const Circle kLine{};

TEST(Isolated, AreNotSeenInHonestSignals) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> gauss(0.0, 1.0);
  const auto none_in = [](const std::vector<double>& values) {
    return find_isolated(values, kLine).places.empty();
  };
  // Gaussian noise alone: an excursion of 8 times the 90 % point (2.0 sigma) is 16 sigma.
  EXPECT_TRUE(none_in(sampled(200000, [&](double) { return gauss(random); })));
  EXPECT_TRUE(none_in(sampled(6000, [](double i) { return std::sin(i / 30.0); })));
  EXPECT_TRUE(
      none_in(sampled(6000, [](double i) { return static_cast<int>(i / 40.0) % 2 * 5.0; })));
  EXPECT_TRUE(none_in(sampled(6000, [](double i) { return std::sin(i * i / 4000.0); })));  // chirp
  // A sensor's last digit: still but for rare flickers.
  EXPECT_TRUE(
      none_in(sampled(6000, [](double i) { return std::fmod(i, 97.0) == 5.0 ? 301.0 : 300.0; })));
  // Quiet, then rough.
  EXPECT_TRUE(none_in(sampled(60000, [&](double i) {
    return std::sin(i / 300.0) + (i > 59000.0 ? 1.0 : 0.001) * gauss(random);
  })));
}

// In the quiet part of a noisy run: the 90 % point of the whole is 2.0 (see above), 8 times it 16.
TEST(Isolated, MustStandOutOfTheWholeRun) {
  for (const auto& [size, count] :
       std::vector<std::pair<double, std::size_t>>{{12.0, 0}, {20.0, 1}}) {
    std::mt19937_64 random(4);
    std::normal_distribution<double> gauss(0.0, 1.0);
    auto values =
        sampled(20000, [&](double i) { return (i > 19000.0 ? 0.001 : 1.0) * gauss(random); });
    values[19500] = size;
    EXPECT_EQ(find_isolated(values, kLine).places.size(), count) << size;
  }
}

// The place and size of each were drawn; all must be found, and nothing else.
TEST(Isolated, AreAllFoundInNoise) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> gauss(0.0, 0.01);
  auto values = sampled(20000, [&](double i) { return std::sin(i / 100.0) + gauss(random); });
  for (std::size_t i = 100; i < 19900; i += 400) values[i] += (i % 800 == 100) ? 2.0 : -2.0;
  const IsolatedSamples found = find_isolated(values, kLine);
  EXPECT_EQ(found.places.size(), 50u);
  EXPECT_FALSE(found.is_crowd);
  for (const auto& [begin, length] : found.places) {
    EXPECT_EQ(begin % 400, 100u);
    EXPECT_EQ(length, 1u);
  }
}

TEST(Wrap, IsNotSeenWhereNothingStartsAnew) {
  EXPECT_FALSE(is_wrapped(sampled(1000, [](double i) { return 3.0 * std::sin(i / 50.0); }),
                          2 * kStraightAngle));
  EXPECT_FALSE(is_wrapped(sampled(1000, [](double i) { return 0.1 * i; }), 2 * kStraightAngle));
  // Steps of a turn that run on are turns that were asked for.
  EXPECT_FALSE(
      is_wrapped(sampled(1000, [](double i) { return 2 * kStraightAngle * std::floor(i / 100.0); }),
                 2 * kStraightAngle));
}

// From -2.5 to 2.5 rad and back at once: less than nine tenths of a turn.
TEST(Wrap, IsNotSeenInSteps) {
  EXPECT_FALSE(is_wrapped(
      sampled(1000, [](double i) { return static_cast<int>(i / 100.0) % 2 * 5.0 - 2.5; }),
      2 * kStraightAngle));
}

TEST(Wrap, CountsJumps) {
  auto values = sampled(1000, [](double i) { return std::fmod(0.02 * i, 2 * kStraightAngle); });
  ASSERT_TRUE(is_wrapped(values, 2 * kStraightAngle));
  EXPECT_EQ(unwrap(values, 2 * kStraightAngle).size(), 3u);  // 19.98 rad are 3.18 turns
  EXPECT_NEAR(values.back(), 19.98, 1e-12);
}

}  // namespace
}  // namespace torquewright::identification
