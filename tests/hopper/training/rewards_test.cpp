// SPDX-License-Identifier: Apache-2.0
// Oracle: the formulas of seed 000 (table 1, A.2) and seed 001 (tables III, IV), worked out by hand
// in the comments, and limits of the barrier.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hopper/training/episode/reward_sum.hpp"
#include "hopper/training/rewards/barrier.hpp"
#include "hopper/training/rewards/every_reward.hpp"
#include "hopper/training/rewards/library.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kRounding = 1e-12;

/// In flight at 0.7 s, with joints (0.5, -0.2) rad at (3, -4) rad/s.
RewardInstant flying() {
  RewardInstant at;
  at.time_s = 0.7;
  at.asked.phase = {0.5, 1.05, 2.0, 0.0};
  at.asked.turn_rad = 2.0 * std::numbers::pi;
  at.joint_rad = Eigen::Vector2d(0.5, -0.2);
  at.joint_rad_s = Eigen::Vector2d(3.0, -4.0);
  at.joint_rad_s_before = Eigen::Vector2d(1.0, -1.0);
  at.reference_rad = Eigen::Vector2d(1.5, -0.2);
  at.joint_Nm = Eigen::Vector2d(120.0, 45.0);
  at.action = Eigen::Vector2d(1.0, 0.0);
  at.action_before = Eigen::Vector2d(0.0, 0.5);
  at.action_before_that = Eigen::Vector2d(0.0, 0.0);
  at.touches = at.touches_before = TouchingPoints::Constant(2, false);
  at.impulse_N_s = Eigen::VectorXd::Zero(6);
  at.load_Nm = Eigen::Vector2d(10.0, 29.5);
  at.rotation_rad_s = Eigen::Vector3d(0.0, 7.0, 0.0);
  at.momentum_Nm_s = Eigen::Vector3d(0.0, 6.0, 0.0);
  at.base_rate_rad_s = Eigen::Vector3d(0.0, 8.0, 0.0);
  return at;
}

/// The seed's W = diag(0.5, 2).
RewardNumbers numbers_of(const RewardTerm& term) {
  RewardNumbers numbers = term.usual;
  numbers.joint_weight = Eigen::Vector2d(0.5, 2.0);
  numbers.joint_least = Eigen::Vector2d::Constant(numbers.least);
  numbers.joint_greatest = Eigen::Vector2d::Constant(numbers.greatest);
  return numbers;
}

double value_of(const RewardTerm& term, const RewardInstant& at) {
  return term.value(at, numbers_of(term));
}

TEST(Barrier, IsALogarithmAndBelowItsSoftnessTheParabolaThatGoesOn) {
  EXPECT_NEAR(relaxed_log(0.5, 0.08), std::log(0.5), kRounding);
  EXPECT_NEAR(relaxed_log(0.08, 0.08), std::log(0.08), kRounding);
  // At 0: log 0.08 - (4 - 1) / 2.
  EXPECT_NEAR(relaxed_log(0.0, 0.08), std::log(0.08) - 1.5, kRounding);
  // At -0.08: log 0.08 - (9 - 1) / 2.
  EXPECT_NEAR(relaxed_log(-0.08, 0.08), std::log(0.08) - 4.0, kRounding);
  // Slopes meet at 1 / softness: central differences on either side, second order in the step.
  const double step = 1e-5;
  const double below = (relaxed_log(0.08, 0.08) - relaxed_log(0.08 - step, 0.08)) / step;
  const double above = (relaxed_log(0.08 + step, 0.08) - relaxed_log(0.08, 0.08)) / step;
  EXPECT_NEAR(below, 1.0 / 0.08, step / (0.08 * 0.08));
  EXPECT_NEAR(above, 1.0 / 0.08, step / (0.08 * 0.08));
}

TEST(FlipRewards, AreTheSeedsFormulas) {
  RewardInstant at = flying();
  // |W tau| = |(60, 90)| = 108.1665...; its norm, not its square.
  EXPECT_NEAR(value_of(rewards::torque, at), std::exp(-5e-3 * std::sqrt(11700.0)), kRounding);
  // W (q - q0) = (-0.5, 0).
  EXPECT_NEAR(value_of(rewards::joint_position, at), std::exp(-5e-2 * 0.25), kRounding);
  // W qd = (1.5, -8): 66.25.
  EXPECT_NEAR(value_of(rewards::joint_speed, at), std::exp(-5e-3 * 66.25), kRounding);
  // W (qd - qd') = (1, -6): 37.
  EXPECT_NEAR(value_of(rewards::joint_acceleration, at), std::exp(-1e-3 * 37.0), kRounding);
  // a - 2 a' + a'' = (1, -1): 2.
  EXPECT_NEAR(value_of(rewards::smooth_action, at), std::exp(-0.18 * 2.0), kRounding);
  at.base_velocity_m_s = Eigen::Vector3d(0.6, 0.8, 3.0);
  EXPECT_NEAR(value_of(rewards::linear_velocity, at), std::exp(-1.0), kRounding);
  at.foot_velocity_m_s = Eigen::Vector3d(1.0, 2.0, 9.0);
  EXPECT_NEAR(value_of(rewards::slip, at), std::exp(-0.2 * 5.0), kRounding);
  at.impulse_N_s[2] = 0.1;
  EXPECT_NEAR(value_of(rewards::contact_impulse, at), std::exp(-1.0), kRounding);
  EXPECT_EQ(value_of(rewards::contact_change, at), 1.0);
  at.touches[1] = true;
  EXPECT_NEAR(value_of(rewards::contact_change, at), std::exp(-1.0), kRounding);
}

TEST(FlipRewards, PayForRotationInTheAirAndForRestAfterIt) {
  RewardInstant at = flying();
  EXPECT_EQ(value_of(rewards::cav, at), 7.0);
  EXPECT_EQ(value_of(rewards::cam, at), 6.0);
  EXPECT_EQ(value_of(rewards::bav, at), 8.0);
  at.rotation_rad_s.y() = 12.0;
  EXPECT_EQ(value_of(rewards::cav, at), 10.0);
  at.rotation_rad_s.y() = -3.0;
  EXPECT_EQ(value_of(rewards::cav, at), -0.1);
  at.time_s = 0.49;
  EXPECT_EQ(value_of(rewards::cav, at), 0.0);
  at.time_s = 1.05;
  at.momentum_Nm_s = Eigen::Vector3d(0.6, 0.8, 0.0);
  EXPECT_NEAR(value_of(rewards::cav, at), -0.5, kRounding);
  at.momentum_Nm_s = Eigen::Vector3d(3.0, 4.0, 0.0);
  EXPECT_NEAR(value_of(rewards::cav, at), -1.25, kRounding);
  at.time_s = 2.0;  // the seed's r_CAV is stated until here
  EXPECT_EQ(value_of(rewards::cav, at), 0.0);
  at = flying();
  at.turned_rad = 2.0 * std::numbers::pi - 0.1;  // ours: enough
  EXPECT_EQ(value_of(rewards::cav, at), 0.0);
}

TEST(FlipRewards, FollowAMotionAndStayOnTheGroundBesideTheFlight) {
  RewardInstant at = flying();
  EXPECT_EQ(value_of(rewards::follow, at), 0.0);  // nothing is followed
  at.followed_rad = Eigen::Vector2d(0.9, -0.1);
  at.followed_turn_rad = 0.3;
  at.turned_rad = 0.2;
  // W (q - followed) = (0.5 (-0.4), 2 (-0.1)), and the turn -0.1: 0.04 + 0.04 + 0.01.
  EXPECT_NEAR(value_of(rewards::follow, at), std::exp(-4.0 * 0.09), kRounding);
  EXPECT_EQ(value_of(rewards::grounded, at), 0.0);
  at.time_s = 0.39;  // 0.11 s before the take-off
  EXPECT_EQ(value_of(rewards::grounded, at), 1.0);
  at.touches[0] = true;
  EXPECT_EQ(value_of(rewards::grounded, at), 0.0);
  at.touches[0] = false;
  at.time_s = 1.16;  // as long after the landing
  EXPECT_EQ(value_of(rewards::grounded, at), 1.0);
}

TEST(FlipRewards, AFurtherFlightIsOneMoreThanTheGoalHas) {
  RewardInstant at = flying();
  at.asked.flights = 1;
  EXPECT_EQ(value_of(rewards::further_flight, at), 0.0);  // its first
  at.flights = 1;
  EXPECT_EQ(value_of(rewards::further_flight, at), 1.0);
  at.touches[0] = true;
  EXPECT_EQ(value_of(rewards::further_flight, at), 0.0);
}

TEST(FlipRewards, BarriersSumOverJointsAndGears) {
  const RewardInstant at = flying();
  // b(10) + b(29.5; delta 1): log 40 + log 20 + log 59.5 + (log 1 - ((0.5 - 2)^2 - 1) / 2).
  EXPECT_NEAR(value_of(rewards::load_barrier, at),
              std::log(40.0) + std::log(20.0) + std::log(59.5) - 0.625, kRounding);
  // Weights 0.5 and 2, ends +-8, delta 2: 3 rad/s and -4 rad/s.
  EXPECT_NEAR(value_of(rewards::speed_barrier, at),
              0.5 * (std::log(11.0) + std::log(5.0)) + 2.0 * (std::log(4.0) + std::log(12.0)),
              kRounding);
  RewardNumbers open = numbers_of(rewards::position_barrier);
  open.joint_least = Eigen::Vector2d(0.0, -std::numeric_limits<double>::infinity());
  open.joint_greatest = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  EXPECT_NEAR(rewards::position_barrier.value(at, open), 0.5 * std::log(0.5), kRounding);
}

TEST(HopRewards, AreTheSeedsFormulas) {
  RewardInstant at = flying();
  at.asked.phase = {0.0, 0.0, 0.0, 0.8};
  at.asked.forward_m_s = 0.8;
  at.base_velocity_m_s = Eigen::Vector3d(0.6, 0.0, 1.0);
  EXPECT_NEAR(value_of(rewards::forward_tracking, at), std::exp(-5.0 * 0.04), kRounding);
  at.tilt_rad = 0.3;
  EXPECT_NEAR(value_of(rewards::tilt, at), 0.09, kRounding);
  // At 0.7 of 0.8 s the wave is sin(7/4 pi) = -sqrt(1/2); in the air that counts +sqrt(1/2).
  const double wave = std::sqrt(0.5);
  EXPECT_NEAR(value_of(rewards::gait_barrier, at), std::log(wave + 0.3) + std::log(2.0 - wave),
              kRounding);
  at.touches.setConstant(true);
  // -wave + 0.3 = -0.407 lies below delta: log 0.08 - (((-0.407 - 0.16) / 0.08)^2 - 1) / 2.
  const double inside = (0.3 - wave - 0.16) / 0.08;
  EXPECT_NEAR(value_of(rewards::gait_barrier, at),
              std::log(0.08) - 0.5 * (inside * inside - 1.0) + std::log(2.0 + wave), kRounding);
}

TEST(RewardSum, MultipliesFactorsAndAddsHeads) {
  RewardInstant at = flying();
  at.base_velocity_m_s.setZero();
  std::vector<ReadyReward> list;
  for (const RewardTerm* term :
       {&rewards::cav, &rewards::linear_velocity, &rewards::alive, &rewards::forward_tracking,
        &rewards::tilt, &rewards::load_barrier}) {
    list.push_back({term, numbers_of(*term)});
  }
  at.tilt_rad = 1.0;
  const std::vector<double> heads = rewards_of(list, at);
  ASSERT_EQ(heads.size(), 2u);
  // (1 + 3 * 7) * 0.1 + exp(0.2 * -1) * 1 + 1
  EXPECT_NEAR(heads[0], 2.2 + std::exp(-0.2) + 1.0, kRounding);
  EXPECT_NEAR(heads[1], 0.02 * value_of(rewards::load_barrier, at), kRounding);
}

TEST(RewardSum, NamesTheTermThatIsNoNumberAndTheState) {
  RewardInstant at = flying();
  at.joint_Nm[0] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<ReadyReward> list{{&rewards::alive, numbers_of(rewards::alive)},
                                      {&rewards::torque, numbers_of(rewards::torque)}};
  try {
    rewards_of(list, at);
    FAIL() << "a sum that is no number was returned";
  } catch (const std::domain_error& error) {
    const std::string words = error.what();
    EXPECT_NE(words.find("torque"), std::string::npos) << words;
    EXPECT_NE(words.find("t = 0.7 s"), std::string::npos) << words;
    EXPECT_NE(words.find("joints at 0.5, -0.2 rad"), std::string::npos) << words;
  }
}

TEST(EveryReward, HasANameOfItsOwnASentenceAndAValue) {
  for (const RewardTerm* term : every_reward()) {
    EXPECT_EQ(reward_named(term->name), term);
    EXPECT_FALSE(term->sentence.empty());
    ASSERT_NE(term->value, nullptr);
    EXPECT_TRUE(std::isfinite(value_of(*term, flying()))) << term->name;
  }
  EXPECT_EQ(reward_named("cavv"), nullptr);
}

}  // namespace
}  // namespace torquewright::hopper
