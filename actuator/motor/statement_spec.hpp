// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "actuator/motor/statement.hpp"

namespace torquewright::actuator {

/// A number as it stands, plain or as {"value": ..., "side": ..., "ampere": ..., "tolerance": ...};
/// what stands beside it goes to `statements`. Requires what the schema of `actuator` demands.
double read_stated(const nlohmann::json& value, std::string pointer,
                   std::vector<Statement>& statements);

}  // namespace torquewright::actuator
