// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/drive_check/report.hpp"

namespace torquewright::report {

/// What `actuator check` says: a verdict, a paragraph a joint, the findings.
/// One actuator's part of it.
std::string drive_text(const actuator::DriveReport& drive);

/// Findings a line each, then what the regions leave out.
std::string findings_text(const actuator::CheckReport& report);

std::string check_text(const std::string& trajectory, const actuator::CheckReport& report);

}  // namespace torquewright::report
