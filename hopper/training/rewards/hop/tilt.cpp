// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers&) { return at.tilt_rad * at.tilt_rad; }

}  // namespace

const RewardTerm tilt = {
    .name = "tilt",
    .sentence = "square of the base's angle to the attitude of the start (seed 001, r_ori)",
    .role = RewardRole::kCost,
    .usual = {.weight = -1.0},
    .value = value};

}  // namespace torquewright::hopper::rewards
