// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/drive_check/report.hpp"

namespace torquewright::report {

/// What `actuator check` says: a verdict, a paragraph a joint, the findings.
/// One actuator's part of it.
std::string drive_text(const actuator::DriveReport& drive);

/// Findings of that severity and worse ones a line each; where all are listed, then what the
/// regions leave out.
std::string findings_text(const actuator::CheckReport& report,
                          actuator::Severity least = actuator::Severity::kNote);

std::string check_text(const std::string& trajectory, const actuator::CheckReport& report,
                       actuator::Severity least = actuator::Severity::kNote);

}  // namespace torquewright::report
