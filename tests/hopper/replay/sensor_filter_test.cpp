// SPDX-License-Identifier: Apache-2.0
// Oracle: the steady state of the scalar Riccati equation in closed form, and motions at constant
// rates, which rates carry on exactly.
#include "hopper/trials/sensor_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/position_step.hpp"
#include "hopper/trials/sensor_noise.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::VectorXd;

constexpr double kLook_s = 5e-4;
constexpr Eigen::Index kFirstJoint = 7;

const Robot& filtered_robot() {
  static const ReadRobot read = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json");
  return read.robot;
}

VectorXd upright() {
  VectorXd position = VectorXd::Zero(10);
  position[3] = 1.0;
  return position;
}

/// Turning about an axis that is none of the base's, with joints that move.
VectorXd moving() {
  VectorXd velocity(9);
  velocity << 0.3, -0.2, 0.1, 1.0, 2.0, -0.5, 0.7, -0.4, 0.2;
  return velocity;
}

SensorNoiseLevels noisy() {
  SensorNoiseLevels noise;
  noise.distribution = NoiseDistribution::kNormal;
  noise.gravity_direction = 0.05;
  noise.base_rate_rad_s = 1.0;
  noise.joint_position_rad = 0.05;
  noise.joint_velocity_rad_s = 5.0;
  return noise;
}

/// Root of the mean square of what `error_of` finds in each look's estimate, after the first 2000.
template <typename ErrorOf>
double rms_of_estimates(const SensorNoiseLevels& levels, const ErrorOf& error_of) {
  constexpr int kLooks = 200000, kSettled = 2000;
  const dynamics::Tree& tree = filtered_robot().tree;
  const SensorNoise noise(levels, tree, 1, 0);
  SensorFilter filter(levels, tree);
  VectorXd truth = upright();
  double squares = 0.0;
  for (int look = 0; look < kLooks; ++look) {
    VectorXd position = truth, velocity = moving();
    noise.disturb(static_cast<std::uint64_t>(look), position, velocity);
    filter.estimate(look * kLook_s, position, velocity);
    if (look >= kSettled) squares += std::pow(error_of(truth, position), 2);
    dynamics::step_position(tree, truth, moving(), kLook_s, truth);
  }
  return std::sqrt(squares / (kLooks - kSettled));
}

/// Standard deviation that the filter leaves in its steady state.
double steady_deviation(double position_noise, double rate_noise) {
  const double q = std::pow(rate_noise * kLook_s, 2), r = position_noise * position_noise;
  const double carried = 0.5 * (q + std::sqrt(q * q + 4.0 * q * r));
  return std::sqrt(carried * r / (carried + r));
}

TEST(SensorFilter, LeavesOfJointNoiseWhatTheRiccatiEquationSays) {
  const double left = rms_of_estimates(noisy(), [](const VectorXd& truth, const VectorXd& seen) {
    return seen[kFirstJoint] - truth[kFirstJoint];
  });
  // 200,000 looks of which some 100 are alike: 2000 samples, 1.6 % each deviation.
  EXPECT_NEAR(left / steady_deviation(0.05, 5.0), 1.0, 0.05);
}

// Of the error of a direction d, across it and alike to every side, the part along x has the share
// 1 - d_x^2 of the variance.
TEST(SensorFilter, LeavesOfTiltWhatTheRiccatiEquationSays) {
  double shares = 0.0;
  std::size_t looks = 0;
  const double left = rms_of_estimates(noisy(), [&](const VectorXd& truth, const VectorXd& seen) {
    const auto down_x = [](const VectorXd& q) {  // of the world's down in the base's axes
      return -2.0 * (q[4] * q[6] - q[3] * q[5]);
    };
    shares += 1.0 - std::pow(down_x(truth), 2);
    ++looks;
    return down_x(seen) - down_x(truth);
  });
  const double share = shares / static_cast<double>(looks);
  EXPECT_NEAR(left / (std::sqrt(share) * steady_deviation(0.05, 1.0)), 1.0, 0.05);
}

TEST(SensorFilter, ChangesNothingThatHasNoNoise) {
  const dynamics::Tree& tree = filtered_robot().tree;
  SensorFilter filter({}, tree);
  VectorXd position = upright();
  filter.estimate(0.0, position, moving());
  position = upright();
  position[kFirstJoint] = 0.7;  // where no rate leads
  filter.estimate(kLook_s, position, moving());
  EXPECT_NEAR(position[kFirstJoint], 0.7, 1e-12);
}

// Without noise of the rates nothing is forgotten: the estimate is the mean of all looks.
TEST(SensorFilter, AveragesWhereRatesAreExact) {
  SensorNoiseLevels levels;
  levels.joint_position_rad = 0.05;
  const dynamics::Tree& tree = filtered_robot().tree;
  SensorFilter filter(levels, tree);
  double sum_rad = 0.0;
  for (int look = 0; look < 10; ++look) {
    VectorXd position = upright();
    position[kFirstJoint] = 0.01 * look * look;
    sum_rad += position[kFirstJoint];
    filter.estimate(look * kLook_s, position, VectorXd::Zero(9));
    EXPECT_NEAR(position[kFirstJoint], sum_rad / (look + 1.0), 1e-12) << look;
  }
}

}  // namespace
}  // namespace torquewright::hopper
