// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

/// A flight may begin and end so much beside its times.
constexpr double kLeeway_s = 0.1;

double value(const RewardInstant& at, const RewardNumbers&) {
  const PhaseTimes& phase = at.asked.phase;
  const bool may_fly =
      at.time_s >= phase.take_off_s - kLeeway_s && at.time_s < phase.landing_s + kLeeway_s;
  return at.is_in_air() && !may_fly ? 1.0 : 0.0;
}

}  // namespace

const RewardTerm grounded = {
    .name = "grounded",
    .sentence = "ours: a price for each step in the air beside the flight's time",
    .role = RewardRole::kExtra,
    .usual = {.weight = -5.0},
    .value = value};

}  // namespace torquewright::hopper::rewards
