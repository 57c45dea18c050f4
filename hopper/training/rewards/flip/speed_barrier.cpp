// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"
#include "hopper/training/rewards/joint_barriers.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return joint_barriers(at.joint_rad_s, numbers);
}

}  // namespace

const RewardTerm speed_barrier = {
    .name = "speed_barrier",
    .sentence = "joints slower than these speeds (seed 000, b_vel; seed 001, b_vel)",
    .role = RewardRole::kBarrier,
    .usual = {.weight = 0.02, .least = -8.0, .greatest = 8.0, .softness = 2.0},
    .ends = JointEnds::kSame,
    .value = value};

}  // namespace torquewright::hopper::rewards
