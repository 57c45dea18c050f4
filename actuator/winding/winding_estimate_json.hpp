// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "actuator/winding/winding_estimate.hpp"

namespace torquewright::actuator {

/// The `winding` of a lint_report; null where nothing bounds a number.
nlohmann::ordered_json winding_json(const WindingEstimate& estimate);

}  // namespace torquewright::actuator
