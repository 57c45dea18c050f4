// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/gearbox/tolerance_report.hpp"

namespace torquewright::report {

std::string tolerance_text(const ToleranceReport& report);

}  // namespace torquewright::report
