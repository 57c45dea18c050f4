// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/training/rewards/reward_term.hpp"

namespace torquewright::hopper {

/// Sum over the joints of their weight times the barrier of their own ends; an end that is infinite
/// is none.
double joint_barriers(const Eigen::VectorXd& values, const RewardNumbers& numbers);

}  // namespace torquewright::hopper
