// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/runs.hpp"

namespace torquewright::identification {

/// Chooses runs that stand for the log where not all rows can be held: all of a log in memory, else
/// as many as hold the allowed rows, evenly spread over the log by rows. Returns indices,
/// ascending.
std::vector<std::size_t> spread_runs(const Runs& runs);

}  // namespace torquewright::identification
