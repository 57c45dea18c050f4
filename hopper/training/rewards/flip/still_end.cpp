// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  if (at.time_s < at.asked.phase.landing_s || at.is_in_air()) return 0.0;
  const double off_rad = at.turned_rad - at.asked.turn_rad;
  const double moving = off_rad * off_rad + at.base_velocity_m_s.squaredNorm() +
                        0.1 * at.base_rate_rad_s.squaredNorm() +
                        0.02 * at.joint_rad_s.squaredNorm();
  return std::exp(-numbers.rate * moving);
}

}  // namespace

const RewardTerm still_end = {.name = "still_end",
                              .sentence =
                                  "ours: feet on the ground, slow joints and a slow base once it "
                                  "has landed, in the attitude of the start",
                              .role = RewardRole::kExtra,
                              .usual = {.weight = 10.0, .rate = 4.0},
                              .value = value};

}  // namespace torquewright::hopper::rewards
