// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  const double off_rad_s = at.base_rate_rad_s.z() - at.asked.yaw_rad_s;
  return std::exp(-numbers.rate * off_rad_s * off_rad_s);
}

}  // namespace

const RewardTerm yaw_tracking = {.name = "yaw_tracking",
                                 .sentence = "the commanded yaw rate (seed 001, r_ang)",
                                 .role = RewardRole::kGain,
                                 .usual = {.weight = 0.5, .rate = 5.0},
                                 .value = value};

}  // namespace torquewright::hopper::rewards
