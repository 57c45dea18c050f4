// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper::rewards {
namespace {

double value(const RewardInstant& at, const RewardNumbers& numbers) {
  return std::exp(-numbers.rate * at.impulse_N_s.squaredNorm());
}

}  // namespace

const RewardTerm contact_impulse = {.name = "contact_impulse",
                                    .sentence =
                                        "small impulses of the contacts in a step of the engine; "
                                        "changes with that step (seed 000, r_ci)",
                                    .role = RewardRole::kPart,
                                    .usual = {.weight = 0.2, .rate = 100.0},
                                    .value = value};

}  // namespace torquewright::hopper::rewards
