// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/runs.hpp"

namespace torquewright::identification {

/// Runs that stand for a log where not all rows can be held: all that are in memory; else as many
/// as hold the rows that may be, evenly spread over the log by rows. Indices, ascending.
std::vector<std::size_t> spread_runs(const Runs& runs);

}  // namespace torquewright::identification
