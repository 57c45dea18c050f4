// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  const auto changed = static_cast<double>((at.touches != at.touches_before).count());
  return std::exp(-numbers.rate * changed);
}

}  // namespace

const RewardTerm contact_change = {.name = "contact_change",
                                   .sentence = "contacts that stay as they are (seed 000, r_cs)",
                                   .role = RewardRole::kPart,
                                   .usual = {.weight = 0.1, .rate = 1.0},
                                   .value = value};

}  // namespace torquewright::hopper::rewards
