// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Reads the logs of one rig. Unambiguous faults are repaired with a finding (wrapped angles,
/// isolated impossible samples, saturated channels, gaps: a gap cuts a run in two of one name);
/// what cannot be read or would mislead throws io::SpecError. A log of more rows than may be in
/// memory comes in pieces. docs/logs.md says which is which.
Log read_log(const std::vector<std::filesystem::path>& files, const Rig& rig,
             std::size_t most_rows_in_memory = kLongestWholeLog);

}  // namespace torquewright::identification
