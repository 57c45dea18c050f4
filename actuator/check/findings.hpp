// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/drive_check/report.hpp"

namespace torquewright::actuator {

/// Returns the findings that follow from the reports, a sentence each, violations first.
/// docs/checks.md lists the rules.
std::vector<Finding> findings_of(const std::vector<DriveReport>& drives);

/// Speeds beyond this many times the no-load speed are not those of this actuator. A choice of
/// ours.
constexpr double kImplausibleSpeed = 3.0;

}  // namespace torquewright::actuator
