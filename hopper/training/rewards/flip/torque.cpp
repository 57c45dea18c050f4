// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return std::exp(-numbers.rate * numbers.joint_weight.cwiseProduct(at.joint_Nm).norm());
}

}  // namespace

const RewardTerm torque = {
    .name = "torque",
    .sentence = "small torques at the joints, by their norm and not its square (seed 000, r_tau)",
    .role = RewardRole::kPart,
    .usual = {.weight = 0.1, .rate = 5e-3},
    .value = value};

}  // namespace torquewright::hopper::rewards
