// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return std::exp(-numbers.rate * at.base_velocity_m_s.head<2>().squaredNorm());
}

}  // namespace

const RewardTerm linear_velocity = {.name = "linear_velocity",
                                    .sentence = "the base stays where it is (seed 000, r_lin)",
                                    .role = RewardRole::kPart,
                                    .usual = {.weight = 0.1, .rate = 1.0},
                                    .value = value};

}  // namespace torquewright::hopper::rewards
