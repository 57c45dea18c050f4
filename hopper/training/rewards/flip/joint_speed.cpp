// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return std::exp(-numbers.rate * numbers.joint_weight.cwiseProduct(at.joint_rad_s).squaredNorm());
}

}  // namespace

const RewardTerm joint_speed = {.name = "joint_speed",
                                .sentence = "slow joints (seed 000, r_v)",
                                .role = RewardRole::kPart,
                                .usual = {.weight = 0.2, .rate = 5e-3},
                                .value = value};

}  // namespace torquewright::hopper::rewards
