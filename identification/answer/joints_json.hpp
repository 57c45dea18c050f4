// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "identification/answer/identify.hpp"

namespace torquewright::identification {

/// Adds "joints" and "load" to a report of a rig whose joints have names: what was found at each
/// joint, and of what the drives move. The entries are those of the report's own lists; a report of
/// one bench is left as it is.
void add_joints(const Identification& found, nlohmann::ordered_json& report);

}  // namespace torquewright::identification
