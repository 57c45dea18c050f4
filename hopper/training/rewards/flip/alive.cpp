// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers&) { return at.fell ? 0.0 : 1.0; }

}  // namespace

const RewardTerm alive = {.name = "alive",
                          .sentence = "ours: every step that it has not fallen",
                          .role = RewardRole::kExtra,
                          .usual = {.weight = 1.0},
                          .value = value};

}  // namespace torquewright::hopper::rewards
