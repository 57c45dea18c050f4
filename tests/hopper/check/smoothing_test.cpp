// SPDX-License-Identifier: Apache-2.0
// Oracles: noise of known deviation on a course of known acceleration; enumeration of samples.
#include "hopper/motion/smoothing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hopper/contact/contact_schedule.hpp"
#include "hopper/motion/slopes.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kStep_s = 1e-3;
constexpr double kSpeed_rad_s = 20.0;

dynamics::Tree hinge() {
  dynamics::Tree tree;
  dynamics::Body body;
  body.inertia.mass_kg = 1;
  body.inertia.inertia_kg_m2.setIdentity();
  tree.bodies = {body, body};
  return tree;
}

/// sin(20 t), its velocity known but for noise of that deviation.
Motion swing(double noise_rad_s, Index samples = 1000) {
  Motion motion;
  oracles::Dice dice(3);
  motion.positions.resize(1, samples);
  motion.velocities.resize(1, samples);
  motion.acceleration_origin = Origin::kAbsent;
  for (Index i = 0; i < samples; ++i) {
    const double t = kStep_s * static_cast<double>(i);
    motion.times_s.push_back(t);
    motion.positions(0, i) = std::sin(kSpeed_rad_s * t);
    // Twelve uniform numbers make a normal one.
    double normal = 0.0;
    for (int k = 0; k < 12; ++k) normal += test::uniform(dice, -0.5, 0.5);
    motion.velocities(0, i) = kSpeed_rad_s * std::cos(kSpeed_rad_s * t) + noise_rad_s * normal;
  }
  return motion;
}

double error_rad_s2(const Motion& motion) {
  double square = 0.0;
  for (Index i = 0; i < motion.samples(); ++i) {
    const double truth = -kSpeed_rad_s * kSpeed_rad_s * std::sin(kSpeed_rad_s * motion.time_s(i));
    square += std::pow(motion.accelerations(0, i) - truth, 2);
  }
  return std::sqrt(square / static_cast<double>(motion.samples()));
}

TEST(Noise, IsFoundBesideACourseThatBends) {
  // 1000 samples know a deviation to some 5 %: a median counts for half of them.
  constexpr double kSampling = 0.15;
  for (const double noise_rad_s : {1e-5, 1e-3, 0.1}) {
    const Motion motion = swing(noise_rad_s);
    EXPECT_NEAR(noise_of_differentiated(hinge(), motion)[0] / noise_rad_s, 1.0, kSampling);
    EXPECT_NEAR(sample_noise(motion, motion.velocities)[0] / noise_rad_s, 1.0, kSampling);
  }
}

TEST(Smoothing, LooksNoFartherThanTheNoiseAsks) {
  EXPECT_EQ(smoothing_of(hinge(), swing(0.0)).reach, 1);
  EXPECT_EQ(smoothing_of(hinge(), swing(1e-5)).reach, 1);
  const Index little = smoothing_of(hinge(), swing(3e-3)).reach;
  const Index much = smoothing_of(hinge(), swing(0.3)).reach;
  EXPECT_GT(little, 1);
  EXPECT_GT(much, little);
}

TEST(Smoothing, ComesNearTheBestWindow) {
  for (const double noise_rad_s : {1e-3, 1e-2, 0.1}) {
    const Motion motion = swing(noise_rad_s);
    double best = 1e9;
    for (const Index reach : {1, 2, 4, 8, 16}) {
      Motion tried = motion;
      derive_rates(hinge(), tried, reach);
      best = std::min(best, error_rad_s2(tried));
    }
    Motion chosen = motion;
    const Smoothing smoothing = smoothing_of(hinge(), motion);
    derive_rates(hinge(), chosen, smoothing.reach);
    // One window beside the best has at most some 2^1.5 of its noise.
    EXPECT_LE(error_rad_s2(chosen), 3.0 * best) << noise_rad_s;
    EXPECT_NEAR(smoothing.acceleration_noise[0],
                noise_rad_s * fitted_acceleration(hinge(), motion, 500, smoothing.reach).gain,
                0.15 * smoothing.acceleration_noise[0]);
  }
}

// Oracle: least squares by hand; over 2 r + 1 even steps a slope holds the noise
// sqrt(3 / (r (r + 1) (2 r + 1))) / step.
TEST(Smoothing, HoldsTheNoiseOfASlope) {
  const Motion motion = swing(0.0, 100);
  for (const Index reach : {1, 2, 4, 8}) {
    const auto r = static_cast<double>(reach);
    const double gain = std::sqrt(3.0 / (r * (r + 1) * (2 * r + 1))) / kStep_s;
    EXPECT_NEAR(fitted_acceleration(hinge(), motion, 50, reach).gain, gain, 1e-9 * gain);
  }
}

// Oracle: a force that makes the acceleration is averaged as the acceleration is.
TEST(SpreadTables, AreWhatDerivedAccelerationsAreOfTheTrueOnes) {
  for (const bool by_velocity : {true, false}) {
    Motion motion = swing(0.0, 60);
    Eigen::MatrixXd force(1, 60);
    motion.velocities(0, 0) = motion.positions(0, 0) = 0.0;
    for (Index i = 0; i < 60; ++i) force(0, i) = i < 30 ? 0.0 : 5.0;  // from 29 to 30 it rises
    for (Index i = 0; i + 1 < 60; ++i) {
      const double mean = 0.5 * (force(0, i) + force(0, i + 1));
      motion.velocities(0, i + 1) = motion.velocities(0, i) + kStep_s * mean;
      motion.positions(0, i + 1) = motion.positions(0, i) + kStep_s * motion.velocities(0, i) +
                                   kStep_s * kStep_s / 6.0 * (2.0 * force(0, i) + force(0, i + 1));
    }
    if (!by_velocity) motion.velocity_origin = Origin::kAbsent;
    motion.reach = 3;
    const Eigen::MatrixXd spread = spread_as_accelerations(motion, force);
    derive_rates(hinge(), motion, 3);
    EXPECT_LE((spread - motion.accelerations).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_GT(spread(0, 27), 0.01);  // its window ends at 30
    EXPECT_NEAR(spread(0, 26), 0.0, 1e-9);
  }
}

TEST(Pressing, ReachesAsFarAsAccelerationsLookAndOverShortGaps) {
  Motion motion = swing(0.0, 60);
  Touching touches = Touching::Constant(1, 60, false);
  for (const Index sample : {20, 28, 40}) touches(0, sample) = true;  // 8 ms and 12 ms apart
  EXPECT_TRUE((pressing(touches, motion) == touches).all());  // accelerations are not derived
  motion.acceleration_origin = Origin::kDerived;
  motion.reach = 2;
  const auto from_to = [&](const Touching& presses) {
    std::string text;
    for (Index i = 0; i < 60; ++i) text += presses(0, i) ? '1' : '0';
    return text;
  };
  std::string expected(60, '0');
  for (std::size_t i = 17; i <= 31; ++i) expected[i] = '1';
  for (std::size_t i = 37; i <= 43; ++i) expected[i] = '1';
  EXPECT_EQ(from_to(pressing(touches, motion)), expected);
  motion.breaks = {39};  // an impact: nothing looks across
  for (std::size_t i = 37; i <= 38; ++i) expected[i] = '0';
  EXPECT_EQ(from_to(pressing(touches, motion)), expected);
}

}  // namespace
}  // namespace torquewright::hopper
