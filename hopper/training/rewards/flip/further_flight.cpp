// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers&) {
  return at.is_in_air() && at.flights >= at.asked.flights ? 1.0 : 0.0;
}

}  // namespace

const RewardTerm further_flight = {
    .name = "further_flight",
    .sentence = "ours: a price for each step in the air behind the last flight that the goal has",
    .role = RewardRole::kExtra,
    .usual = {.weight = -20.0},
    .value = value};

}  // namespace torquewright::hopper::rewards
