// SPDX-License-Identifier: Apache-2.0
// A body in a gap. Oracle: closed forms of uniformly accelerated motion.
#include "identification/forward/free_play.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

namespace torquewright::identification {
namespace {

constexpr double kSample_s = 0.002;
constexpr double kBody_kg_m2 = 0.05;
constexpr double kWidth_rad = 0.02;

/// A push that changes with time only, straight between samples.
class Pushed : public FreeSide {
 public:
  Pushed(std::size_t count, const std::function<double(double)>& push) {
    for (std::size_t i = 0; i < count; ++i) {
      push_Nm_.push_back(push(static_cast<double>(i) * kSample_s));
    }
  }
  std::size_t samples() const override { return push_Nm_.size(); }
  double push_Nm(std::size_t sample, double share, double /*speed_rad_s*/) const override {
    const double next = push_Nm_[std::min(sample + 1, push_Nm_.size() - 1)];
    return push_Nm_[sample] + share * (next - push_Nm_[sample]);
  }

 private:
  std::vector<double> push_Nm_;
};

GapMotion moved(std::size_t count, const std::function<double(double)>& push) {
  return move_in_gap(Pushed(count, push), kBody_kg_m2, kWidth_rad, kSample_s);
}

TEST(FreePlay, RestsOnItsFlankWhileItIsPushedThere) {
  const GapMotion motion = moved(200, [](double t) { return 3.0 + 2.0 * std::sin(20.0 * t); });
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ(motion.place_rad[i], 0.5 * kWidth_rad);
    EXPECT_EQ(motion.acceleration_rad_s2[i], 0.0);
  }
}

// From rest under -P it takes sqrt(2 gap J / P); on the other flank it rests.
TEST(FreePlay, CrossesInTheTimeOfUniformAcceleration) {
  const double push_Nm = 1.0, turn_s = 0.1;
  const GapMotion motion = moved(200, [&](double t) { return t < turn_s ? push_Nm : -push_Nm; });
  const double crossing_s = std::sqrt(2.0 * kWidth_rad * kBody_kg_m2 / push_Nm);
  std::size_t arrived = 0;
  while (motion.place_rad[arrived] > -0.5 * kWidth_rad) ++arrived;
  // The push turns within one step before the turn.
  EXPECT_NEAR(static_cast<double>(arrived) * kSample_s, turn_s + crossing_s, 1.5 * kSample_s);
  EXPECT_EQ(motion.place_rad.back(), -0.5 * kWidth_rad);
}

// It starts and ends at rest: its speeds add up to the gap, its accelerations to nothing, with what
// the meeting takes at once; and in the gap it accelerates by push over inertia.
TEST(FreePlay, AccelerationsHoldTheMeetingOfTheFlanks) {
  const GapMotion motion = moved(200, [](double t) { return t < 0.1 ? 1.0 : -1.0; });
  double speed = 0.0, place = 0.0;
  for (const double acceleration : motion.acceleration_rad_s2) {
    speed += acceleration * kSample_s;
    place += speed * kSample_s;
  }
  EXPECT_NEAR(speed, 0.0, 1e-9);
  EXPECT_NEAR(place, -kWidth_rad, 0.02 * kWidth_rad);
  EXPECT_NEAR(motion.acceleration_rad_s2[53], -1.0 / kBody_kg_m2, 1e-6);
}

// A push that reverses before the gap is crossed brings it back.
TEST(FreePlay, ComesBackIfThePushReturns) {
  const GapMotion motion = moved(200, [](double t) { return t > 0.1 && t < 0.11 ? -1.0 : 1.0; });
  EXPECT_EQ(motion.place_rad.back(), 0.5 * kWidth_rad);
  EXPECT_GT(*std::min_element(motion.place_rad.begin(), motion.place_rad.end()), -0.5 * kWidth_rad);
  EXPECT_LT(*std::min_element(motion.place_rad.begin(), motion.place_rad.end()), 0.5 * kWidth_rad);
}

TEST(FreePlay, NoGapChangesNothing) {
  const Pushed pushed(50, [](double t) { return std::sin(50.0 * t); });
  for (const double each : move_in_gap(pushed, 0.05, 0.0, kSample_s).acceleration_rad_s2) {
    EXPECT_EQ(each, 0.0);
  }
}

}  // namespace
}  // namespace torquewright::identification
