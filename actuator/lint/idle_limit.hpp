// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/lint/finding.hpp"

namespace torquewright::actuator::lint {

/// Returns a note where a drive states how much power may flow back to its bus and also that none
/// does: then the limit is ignored.
std::optional<Finding> idle_regeneration_limit(const Actuator& document);

}  // namespace torquewright::actuator::lint
