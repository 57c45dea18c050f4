// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tests/oracles/loop_bench/situation.hpp"

namespace torquewright::oracles::loop {

/// Writes log.csv, rig.json, actuator.json (or actuator_JOINT.json) and truth.json.
void write_all(const Made& made, const std::filesystem::path& folder);

}  // namespace torquewright::oracles::loop
