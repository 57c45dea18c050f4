// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "actuator/motor/statement.hpp"

namespace torquewright::actuator {

/// A number as it stands, plain or as {"value": ..., "side": ..., "ampere": ..., "bound": ...,
/// "tolerance": ...};
/// what stands beside it goes to `statements`. Requires what the schema of `actuator` demands.
double read_stated(const nlohmann::json& value, std::string pointer,
                   std::vector<Statement>& statements);

/// Pointers to the numbers of the model that are stated by a bound, which a region takes for the
/// numbers themselves.
std::vector<std::string> taken_at_their_bounds(const nlohmann::json& root);

}  // namespace torquewright::actuator
