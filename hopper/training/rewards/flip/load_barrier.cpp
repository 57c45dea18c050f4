// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/barrier.hpp"
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  double sum = 0.0;
  for (const double load_Nm : at.load_Nm) {
    sum += relaxed_barrier(load_Nm, numbers.least, numbers.greatest, numbers.softness);
  }
  return sum;
}

}  // namespace

const RewardTerm load_barrier = {
    .name = "load_barrier",
    .sentence = "what the contacts ask of each gear before its mesh, in Nm (seed 000, b_load)",
    .role = RewardRole::kBarrier,
    .usual = {.weight = 0.02, .least = -30.0, .greatest = 30.0, .softness = 1.0},
    .value = value};

}  // namespace torquewright::hopper::rewards
