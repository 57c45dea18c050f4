// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// By Log::runs: what is left out together. Each group of training runs is a fold; kHeldOut: no fit
/// sees it.
std::vector<std::size_t> run_folds(const Log& log);

}  // namespace torquewright::identification
