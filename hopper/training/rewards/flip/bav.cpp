// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"
#include "hopper/training/rewards/turning.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers&) {
  return paid_for_turning(at, at.base_rate_rad_s.y());
}

}  // namespace

const RewardTerm bav = {
    .name = "bav",
    .sentence = "the base's own pitch rate in the place of r_CAV (seed 000, section 5.1)",
    .role = RewardRole::kFactor,
    .usual = {.weight = 3.0},
    .value = value};

}  // namespace torquewright::hopper::rewards
