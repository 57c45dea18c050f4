// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "actuator/lint/examination.hpp"

namespace torquewright::actuator::lint {

/// Writes a document of kind `lint_report` (specs/schema/lint_report.json) without its provenance
/// ("tool", "inputs").
nlohmann::ordered_json report_json(const Report& report);

}  // namespace torquewright::actuator::lint
