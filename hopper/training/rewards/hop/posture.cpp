// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return numbers.joint_weight.cwiseProduct(at.joint_rad - at.reference_rad).squaredNorm();
}

}  // namespace

const RewardTerm posture = {
    .name = "posture",
    .sentence = "square of the joints' distance from the posture of the start (seed 001, r_pos)",
    .role = RewardRole::kCost,
    .usual = {.weight = -0.1},
    .value = value};

}  // namespace torquewright::hopper::rewards
