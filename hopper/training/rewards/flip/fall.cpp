// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers&) { return at.fell ? 1.0 : 0.0; }

}  // namespace

const RewardTerm fall = {.name = "fall",
                         .sentence = "ours: a price for a fall, once",
                         .role = RewardRole::kExtra,
                         .usual = {.weight = -300.0},
                         .value = value};

}  // namespace torquewright::hopper::rewards
