// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/training/rewards/reward_instant.hpp"

namespace torquewright::hopper {

/// The form of seed 000's r_CAV (table 1) without its weight: nothing before the take-off;
/// `turning` until the landing, from -0.1 to 10; then the price of what angular momentum is left;
/// nothing once the clock has ended.
double paid_for_turning(const RewardInstant& at, double turning);

}  // namespace torquewright::hopper
