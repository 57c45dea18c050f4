// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"
#include "hopper/training/rewards/turning.hpp"

namespace torquewright::hopper::rewards {
namespace {

/// Ours: what has turned that far is paid no more for turning. As the seed has it a policy turns on
/// until it falls.
constexpr double kEnough_rad = 0.17;

double value(const RewardInstant& at, const RewardNumbers&) {
  const bool is_enough = at.turned_rad > at.asked.turn_rad - kEnough_rad;
  return paid_for_turning(at, is_enough ? 0.0 : at.rotation_rad_s.y());
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
