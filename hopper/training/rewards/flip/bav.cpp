// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers&) {
  const PhaseTimes& phase = at.asked.phase;
  if (at.time_s < phase.take_off_s) return 0.0;
  if (at.time_s >= phase.landing_s) return -0.5 * std::min(at.momentum_Nm_s.norm(), 2.5);
  return std::clamp(at.base_rate_rad_s.y(), -0.1, 10.0);
}

}  // namespace

const RewardTerm bav = {
    .name = "bav",
    .sentence = "the base's own pitch rate in the place of r_CAV (seed 000, section 5.1)",
    .role = RewardRole::kFactor,
    .usual = {.weight = 3.0},
    .value = value};

}  // namespace torquewright::hopper::rewards
