// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// A load as a rig states it. `report` is told the key (/mass_kg) and the fault of each value that
/// its type needs and does not have, or has and does not need.
Load load_of_json(const nlohmann::json& load,
                  const std::function<void(const std::string& key, std::string fault)>& report);

/// The joints that the links of an arm name; of those that name one.
std::vector<std::string> joints_of_links(const nlohmann::json& load);

}  // namespace torquewright::identification
