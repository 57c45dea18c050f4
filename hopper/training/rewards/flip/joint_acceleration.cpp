// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  const Eigen::VectorXd change_rad_s = at.joint_rad_s - at.joint_rad_s_before;
  return std::exp(-numbers.rate * numbers.joint_weight.cwiseProduct(change_rad_s).squaredNorm());
}

}  // namespace

const RewardTerm joint_acceleration = {
    .name = "joint_acceleration",
    .sentence = "joints that change their speed little from step to step (seed 000, r_a)",
    .role = RewardRole::kPart,
    .usual = {.weight = 0.2, .rate = 1e-3},
    .value = value};

}  // namespace torquewright::hopper::rewards
