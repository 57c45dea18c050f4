// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/training/rewards/reward_term.hpp"

namespace torquewright::hopper {

/// Returns all terms, in the order in which documents list them.
const std::vector<const RewardTerm*>& every_reward();
std::vector<std::string> reward_names();
/// Returns the term of that name, or null.
const RewardTerm* reward_named(std::string_view name);

}  // namespace torquewright::hopper
