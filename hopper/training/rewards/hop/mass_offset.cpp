// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers&) {
  return at.asked.is_standing ? at.mass_offset_m.squaredNorm() : 0.0;
}

}  // namespace

const RewardTerm mass_offset = {.name = "mass_offset",
                                .sentence =
                                    "square of the centre of mass's way from the middle of the "
                                    "foot, while standing (seed 001, r_com)",
                                .role = RewardRole::kCost,
                                .usual = {.weight = -10.0},
                                .value = value};

}  // namespace torquewright::hopper::rewards
