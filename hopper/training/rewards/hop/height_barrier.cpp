// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/barrier.hpp"
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return relaxed_barrier(at.base_height_m, numbers.least, numbers.greatest, numbers.softness);
}

}  // namespace

const RewardTerm height_barrier = {
    .name = "height_barrier",
    .sentence = "height of the base, in m (seed 001, b_body)",
    .role = RewardRole::kBarrier,
    .usual = {.weight = 0.1, .least = 0.3, .greatest = 1.1, .softness = 0.04},
    .value = value};

}  // namespace torquewright::hopper::rewards
