// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/barrier.hpp"
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return relaxed_barrier(at.base_velocity_m_s.x() - at.asked.forward_m_s, numbers.least,
                         numbers.greatest, numbers.softness);
}

}  // namespace

const RewardTerm tracking_barrier = {
    .name = "tracking_barrier",
    .sentence = "forward velocity about the commanded one, in m/s (seed 001, b_cmd)",
    .role = RewardRole::kBarrier,
    .usual = {.weight = 0.1, .least = -0.6, .greatest = 0.6, .softness = 0.6},
    .value = value};

}  // namespace torquewright::hopper::rewards
