// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "hopper/planning/search/plan.hpp"

namespace torquewright::hopper {

/// Whether a report states how long its rounds took, which differs between runs.
enum class PlanSeconds { kLeftOut, kStated };

/// A document of kind `plan_report` without its provenance ("tool", "inputs", "options"). What is
/// not known or not finite is null.
nlohmann::ordered_json plan_report_json(const PlanOptions& options, const PlanResult& result,
                                        PlanSeconds seconds);

}  // namespace torquewright::hopper
