// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers&) {
  return (at.action - at.action_before).squaredNorm();
}

}  // namespace

const RewardTerm action_rate = {
    .name = "action_rate",
    .sentence = "square of the actions' first difference (seed 001, r_smooth-1)",
    .role = RewardRole::kCost,
    .usual = {.weight = -0.05},
    .value = value};

}  // namespace torquewright::hopper::rewards
