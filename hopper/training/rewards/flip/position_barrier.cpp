// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"
#include "hopper/training/rewards/joint_barriers.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return joint_barriers(at.joint_rad, numbers);
}

}  // namespace

const RewardTerm position_barrier = {
    .name = "position_barrier",
    .sentence = "joints inside their ranges (seed 000, b_pos; seed 001, b_pos)",
    .role = RewardRole::kBarrier,
    .usual = {.weight = 0.02, .softness = 0.08},
    .ends = JointEnds::kRanges,
    .value = value};

}  // namespace torquewright::hopper::rewards
