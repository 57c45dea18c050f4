// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers&) {
  if (!at.fell) return 0.0;
  return std::min(std::abs(at.turned_rad - at.asked.turn_rad), 2.0 * std::numbers::pi);
}

}  // namespace

const RewardTerm missing_turn = {
    .name = "missing_turn",
    .sentence = "ours: a price for a fall by each rad that the base has turned short or too far",
    .role = RewardRole::kExtra,
    .usual = {.weight = -60.0},
    .value = value};

}  // namespace torquewright::hopper::rewards
