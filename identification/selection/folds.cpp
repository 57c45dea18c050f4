// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/folds.hpp"

#include "identification/log/run_groups.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

std::vector<std::size_t> run_folds(const Log& log) {
  std::vector<std::size_t> folds;
  for (const RunGroup& group : run_groups(log)) {
    folds.push_back(group.is_held_out ? kHeldOut : group.number);
  }
  return folds;
}

}  // namespace torquewright::identification
