// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace torquewright::fuzz {

/// Reads and checks a gearbox_result as `gearbox verify` does. What the checker accepts is held
/// against a fresh search of the result's own problem: throws Misbehaviour if they contradict each
/// other.
void verify_result(const std::filesystem::path& file);

}  // namespace torquewright::fuzz
