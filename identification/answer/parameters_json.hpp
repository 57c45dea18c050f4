// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "identification/findings/found_parameters.hpp"

namespace torquewright::identification {

/// Returns the parameters as an actuator document states them; null for what is not finite.
nlohmann::ordered_json parameters_json(const FoundParameters& found);

/// Returns the standard errors under the same keys, without those of what is not fitted (a channel,
/// an order); null for what the log does not determine.
nlohmann::ordered_json standard_errors_json(const FoundParameters& found);

}  // namespace torquewright::identification
