// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

/// Ours: what has turned that far is paid no more for turning. As the seed has it a policy turns on
/// until it falls.
constexpr double kEnough_rad = 0.17;

double value(const RewardInstant& at, const RewardNumbers&) {
  const PhaseTimes& phase = at.asked.phase;
  if (at.time_s < phase.take_off_s) return 0.0;
  if (at.time_s >= phase.landing_s) return -0.5 * std::min(at.momentum_Nm_s.norm(), 2.5);
  if (at.turned_rad > at.asked.turn_rad - kEnough_rad) return 0.0;
  return std::clamp(at.rotation_rad_s.y(), -0.1, 10.0);
}

}  // namespace

const RewardTerm cav = {.name = "cav",
                        .sentence =
                            "centroidal rotation rate in the air and momentum after it (seed 000, "
                            "r_CAV); ours: nothing beyond the asked turn",
                        .role = RewardRole::kFactor,
                        .usual = {.weight = 3.0},
                        .value = value};

}  // namespace torquewright::hopper::rewards
