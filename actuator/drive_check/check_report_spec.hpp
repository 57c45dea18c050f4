// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "actuator/drive_check/report.hpp"

namespace torquewright::actuator {

/// Writes a document of kind `check_report` without its provenance ("tool", "inputs", "options").
/// What is not finite or not known is null.
nlohmann::ordered_json check_report_json(const CheckReport& report);

/// Writes one finding of the report.
nlohmann::ordered_json finding_json(const Finding& finding);

}  // namespace torquewright::actuator
