// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/library.hpp"

#include "hopper/training/rewards/every_reward.hpp"

namespace torquewright::hopper {

const std::vector<const RewardTerm*>& every_reward() {
#define TORQUEWRIGHT_LIST(name) &rewards::name,
  static const std::vector<const RewardTerm*> all{TORQUEWRIGHT_EVERY_REWARD(TORQUEWRIGHT_LIST)};
#undef TORQUEWRIGHT_LIST
  return all;
}

std::vector<std::string> reward_names() {
  std::vector<std::string> names;
  for (const RewardTerm* term : every_reward()) names.emplace_back(term->name);
  return names;
}

const RewardTerm* reward_named(std::string_view name) {
  for (const RewardTerm* term : every_reward()) {
    if (term->name == name) return term;
  }
  return nullptr;
}

}  // namespace torquewright::hopper
