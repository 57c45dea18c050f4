// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return std::exp(-numbers.rate * at.foot_velocity_m_s.head<2>().squaredNorm());
}

}  // namespace

const RewardTerm slip = {
    .name = "slip",
    .sentence = "a foot that does not slide, in the air either (seed 000, r_slip)",
    .role = RewardRole::kPart,
    .usual = {.weight = 0.1, .rate = 0.2},
    .value = value};

}  // namespace torquewright::hopper::rewards
