// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  const Eigen::VectorXd corner = at.action - 2.0 * at.action_before + at.action_before_that;
  return std::exp(-numbers.rate * corner.squaredNorm());
}

}  // namespace

const RewardTerm smooth_action = {
    .name = "smooth_action",
    .sentence = "actions without corners: their second difference (seed 000, r_act)",
    .role = RewardRole::kPart,
    .usual = {.weight = 0.2, .rate = 0.18},
    .value = value};

}  // namespace torquewright::hopper::rewards
