// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  const Eigen::VectorXd off_rad = at.joint_rad - at.reference_rad;
  return std::exp(-numbers.rate * numbers.joint_weight.cwiseProduct(off_rad).squaredNorm());
}

}  // namespace

const RewardTerm joint_position = {
    .name = "joint_position",
    .sentence = "joints near the posture of the start (seed 000, r_p)",
    .role = RewardRole::kPart,
    .usual = {.weight = 0.1, .rate = 5e-2},
    .value = value};

}  // namespace torquewright::hopper::rewards
