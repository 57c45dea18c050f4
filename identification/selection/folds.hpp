// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Returns the fold of each run of the log: runs of one fold are left out together. Each group of
/// training runs is a fold; kHeldOut: no fit sees the run.
std::vector<std::size_t> run_folds(const Log& log);

}  // namespace torquewright::identification
