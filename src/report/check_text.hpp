// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/check/report.hpp"

namespace torquewright::report {

/// What `actuator check` says: a verdict, a paragraph a joint, the findings.
std::string check_text(const std::string& trajectory, const actuator::CheckReport& report);

}  // namespace torquewright::report
