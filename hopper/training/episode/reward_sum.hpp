// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/training/task/ready_task.hpp"

namespace torquewright::hopper {

/// Heads of the rewards of a task.
inline constexpr int kRewardHeads = 2;

/// The rewards of a control step: motion and barrier, as RewardRole says. Throws std::domain_error,
/// naming the term and the state, where a term is not finite.
std::vector<double> rewards_of(const std::vector<ReadyReward>& rewards, const RewardInstant& at);

}  // namespace torquewright::hopper
