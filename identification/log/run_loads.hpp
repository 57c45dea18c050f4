// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// What the parts of an only run are called, behind its name: docs/logs.md.
constexpr std::string_view kFirstPart = " (first two thirds)", kLastPart = " (last third)";

/// Throws io::SpecError for each of these runs that no load is stated for, and each load of a run
/// that is none of them (with the nearest).
void check_run_loads(const std::vector<std::string>& runs, const Rig& rig);

}  // namespace torquewright::identification
