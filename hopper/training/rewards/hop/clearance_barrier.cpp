// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hopper/training/rewards/barrier.hpp"
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  if (!(at.asked.phase.period_s > 0.0)) return 0.0;
  const double wave = std::sin(2.0 * std::numbers::pi * at.time_s / at.asked.phase.period_s);
  const double asked_m = at.asked.clearance_m * std::max(0.0, -wave);
  return relaxed_barrier(at.foot_height_m - asked_m, numbers.least, numbers.greatest,
                         numbers.softness);
}

}  // namespace

const RewardTerm clearance_barrier = {
    .name = "clearance_barrier",
    .sentence =
        "height of the foot over the asked one, in the middle of the flight (seed 001, b_foot)",
    .role = RewardRole::kBarrier,
    .usual = {.weight = 0.1, .least = -0.08, .greatest = 1.0, .softness = 0.02},
    .value = value};

}  // namespace torquewright::hopper::rewards
