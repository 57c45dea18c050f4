// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// Endings of the names of an only run's two parts (docs/logs.md).
constexpr std::string_view kFirstPart = " (first two thirds)", kLastPart = " (last third)";
constexpr std::string_view kFittedStates = " (two thirds of the states)",
                           kHeldOutStates = " (a third of the states)";

/// Throws io::SpecError for each run without a stated load, and for each load of a run that does
/// not exist (with the nearest name).
void check_run_loads(const std::vector<std::string>& runs, const Rig& rig);

}  // namespace torquewright::identification
