// SPDX-License-Identifier: Apache-2.0
// Oracle: the same course of more hops, written down sample by sample.
#include "hopper/motion/further_hops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/faults/spec_error.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kFurtherStep_s = 0.01;
constexpr double kPeriod_s = 0.5;  ///< Of hops, in the air from 0.1 to 0.3 s of it.
constexpr double kForward_m_s = 0.4;
constexpr Index kKneePosition = 7, kKneeRate = 6;

const Robot& hopping_robot() {
  static const ReadRobot read = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json");
  return read.robot;
}

/// Goes on evenly, its knee to and fro once a hop, and lands with a break; then stands for 0.2 s.
Motion course(int hops) {
  Motion motion;
  const auto samples =
      static_cast<Index>(std::lround((hops * kPeriod_s + 0.2) / kFurtherStep_s)) + 1;
  motion.positions.setZero(10, samples);
  motion.velocities.setZero(9, samples);
  motion.accelerations.setZero(9, samples);
  motion.touching.setZero(4, samples);
  motion.has_touching = true;
  const double turn_rad_s = 2.0 * std::numbers::pi / kPeriod_s;
  for (Index i = 0; i < samples; ++i) {
    const double time_s = kFurtherStep_s * static_cast<double>(i);
    const Index within = i % 50;
    const bool flies = within >= 10 && within < 30 && i < 50 * hops;
    motion.times_s.push_back(time_s);
    motion.positions.col(i).head<4>() << kForward_m_s * time_s, 0.0, 1.0, 1.0;
    motion.positions(kKneePosition, i) = 0.1 * std::sin(turn_rad_s * time_s);
    motion.velocities(0, i) = kForward_m_s;
    motion.velocities(kKneeRate, i) = 0.1 * turn_rad_s * std::cos(turn_rad_s * time_s);
    motion.touching.col(i).setConstant(flies ? 0.0 : 1.0);
    if (within == 30 && i < 50 * hops) motion.breaks.push_back(i);
  }
  return motion;
}

std::string refusal(Motion motion, int flights) {
  try {
    (void)with_flights(hopping_robot(), std::move(motion), flights);
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "none";
}

TEST(FurtherHops, AreTheCourseOfSoManyHops) {
  for (const int flights : {2, 3, 7}) {
    const Motion made = with_flights(hopping_robot(), course(2), flights), wanted = course(flights);
    ASSERT_EQ(made.samples(), wanted.samples());
    for (Index i = 0; i < made.samples(); ++i) EXPECT_NEAR(made.time_s(i), wanted.time_s(i), 1e-12);
    EXPECT_LT((made.positions - wanted.positions).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((made.velocities - wanted.velocities).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_EQ(made.touching, wanted.touching);
    EXPECT_EQ(made.breaks, wanted.breaks);
  }
}

TEST(FurtherHops, AreOfHopsThatAreAlike) {
  Motion drifts = course(3);
  for (Index i = 0; i < drifts.samples(); ++i)
    drifts.positions(kKneePosition, i) += 0.05 * drifts.time_s(i);
  const std::string said = refusal(drifts, 6);
  EXPECT_NE(said.find("t = 0.6 and 1.1 s are not alike: knee's position differs by 0.025"),
            std::string::npos)
      << said;
  Motion speeds_up = course(3);
  for (Index i = 0; i < speeds_up.samples(); ++i) speeds_up.velocities(0, i) += speeds_up.time_s(i);
  EXPECT_NE(refusal(speeds_up, 6).find("base_x's velocity differs by 0.5"), std::string::npos)
      << refusal(speeds_up, 6);
}

TEST(FurtherHops, AreOfMotionsThatTakeOffTwice) {
  EXPECT_NE(refusal(course(1), 4).find("takes off once"), std::string::npos);
  EXPECT_NE(refusal(course(5), 4).find("flies 5 times already"), std::string::npos);
  Motion mute = course(2);
  mute.has_touching = false;
  EXPECT_NE(refusal(mute, 4).find("which contacts touch"), std::string::npos);
  Motion stepped = course(2);
  stepped.ground.edges_x_m = {0.3};
  stepped.ground.heights_m = {0.0, 0.1};
  EXPECT_NE(refusal(stepped, 4).find("flat ground"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::hopper
