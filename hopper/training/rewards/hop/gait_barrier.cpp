// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "hopper/training/rewards/barrier.hpp"
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  if (!(at.asked.phase.period_s > 0.0)) return 0.0;
  const double wave = std::sin(2.0 * std::numbers::pi * at.time_s / at.asked.phase.period_s);
  return relaxed_barrier(at.is_in_air() ? -wave : wave, numbers.least, numbers.greatest,
                         numbers.softness);
}

}  // namespace

const RewardTerm gait_barrier = {
    .name = "gait_barrier",
    .sentence =
        "contact in the first half of the period, flight in the second: the period's sine, signed "
        "by contact (seed 001, b_gait)",
    .role = RewardRole::kBarrier,
    .usual = {.weight = 0.1, .least = -0.3, .greatest = 2.0, .softness = 0.08},
    .value = value};

}  // namespace torquewright::hopper::rewards
