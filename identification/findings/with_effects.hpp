// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// Returns the actuator with the effects that were found (those of family actuator), in place of
/// those that they replace. refined_actuator() in refined_json.hpp writes the same as a document.
actuator::Actuator with_effects(actuator::Actuator actuator, const std::vector<NamedEffect>& found);

/// Whether a list of names separated by commas contains this one.
bool is_listed(const std::string& names, std::string_view name);

}  // namespace torquewright::identification
