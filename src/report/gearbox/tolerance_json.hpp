// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "src/report/gearbox/tolerance_report.hpp"

namespace torquewright::report {

/// A document of kind tolerance_report without its provenance.
nlohmann::ordered_json tolerance_json(const ToleranceReport& report);

}  // namespace torquewright::report
