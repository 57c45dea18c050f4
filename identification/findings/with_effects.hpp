// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// An actuator with effects that were found (those of family actuator), in the place of those that
/// they replace. The document's counterpart: refined_actuator in identify.hpp.
actuator::Actuator with_effects(actuator::Actuator actuator, const std::vector<NamedEffect>& found);

/// Whether a list of names, separated by commas, holds one.
bool is_listed(const std::string& names, std::string_view name);

}  // namespace torquewright::identification
