// SPDX-License-Identifier: Apache-2.0
#include "identification/log/run_groups.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace torquewright::identification {

double runs_per_group(const Log& log) {
  if (log.runs.is_in_memory()) return 1.0;
  const auto names = static_cast<double>(log.train_runs.size() + log.holdout_runs.size());
  return std::max(1.0, names / static_cast<double>(kMostGroups));
}

std::vector<RunGroup> run_groups(const Log& log) {
  const std::set<std::string> held_out(log.holdout_runs.begin(), log.holdout_runs.end());
  const double per_group = runs_per_group(log);
  std::map<std::string, std::size_t> to_fit, to_judge;
  std::vector<RunGroup> groups;
  for (std::size_t i = 0; i < log.runs.size(); ++i) {
    const std::string& name = log.runs.head(i).name;
    const bool is_held_out = held_out.count(name) != 0;
    auto& numbers = is_held_out ? to_judge : to_fit;
    const std::size_t number = numbers.try_emplace(name, numbers.size()).first->second;
    groups.push_back(
        {static_cast<std::size_t>(static_cast<double>(number) / per_group), is_held_out});
  }
  return groups;
}

}  // namespace torquewright::identification
