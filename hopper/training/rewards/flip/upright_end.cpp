// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  if (at.time_s < at.asked.phase.landing_s) return 0.0;
  const double off_rad = at.turned_rad - at.asked.turn_rad;
  return std::exp(-numbers.rate * off_rad * off_rad);
}

}  // namespace

const RewardTerm upright_end = {
    .name = "upright_end",
    .sentence =
        "ours: the base in the attitude of the start, one asked turn later, once it has landed",
    .role = RewardRole::kExtra,
    .usual = {.weight = 10.0, .rate = 4.0},
    .value = value};

}  // namespace torquewright::hopper::rewards
