// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// Reads a load as a rig states it. `report` is told the key (/mass_kg) and the fault of each value
/// that its type needs and lacks, or has and does not need.
Load load_of_json(const nlohmann::json& load,
                  const std::function<void(const std::string& key, std::string fault)>& report);

/// Returns the joints that the links of an arm name, for the links that name one.
std::vector<std::string> joints_of_links(const nlohmann::json& load);

}  // namespace torquewright::identification
