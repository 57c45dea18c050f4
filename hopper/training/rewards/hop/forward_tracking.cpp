// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  const Eigen::Vector2d off_m_s =
      at.base_velocity_m_s.head<2>() - Eigen::Vector2d(at.asked.forward_m_s, 0.0);
  return std::exp(-numbers.rate * off_m_s.squaredNorm());
}

}  // namespace

const RewardTerm forward_tracking = {
    .name = "forward_tracking",
    .sentence = "the commanded velocity over the ground (seed 001, r_lin)",
    .role = RewardRole::kGain,
    .usual = {.weight = 1.0, .rate = 5.0},
    .value = value};

}  // namespace torquewright::hopper::rewards
