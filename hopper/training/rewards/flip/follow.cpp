// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  if (at.followed_rad.size() == 0) return 0.0;
  const Eigen::VectorXd off_rad = at.joint_rad - at.followed_rad;
  const double turn_rad = at.turned_rad - at.followed_turn_rad;
  return std::exp(-numbers.rate *
                  (numbers.joint_weight.cwiseProduct(off_rad).squaredNorm() + turn_rad * turn_rad));
}

}  // namespace

const RewardTerm follow = {.name = "follow",
                           .sentence =
                               "ours: joints and turn of the base as the motion of --reference, "
                               "which it needs, has them then",
                           .role = RewardRole::kExtra,
                           .usual = {.weight = 10.0, .rate = 4.0},
                           .value = value};

}  // namespace torquewright::hopper::rewards
