// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "src/commands/planning/robust_choice.hpp"

namespace torquewright::cli {

/// How a reserve was chosen, as a plan_report has it.
nlohmann::ordered_json robust_json(const RobustChoice& robust);

}  // namespace torquewright::cli
