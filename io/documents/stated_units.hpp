// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "io/faults/spec_error.hpp"

namespace torquewright::io {

/// Numbers that say their unit, {"value": 93, "unit": "mohm"}, become numbers in the unit of their
/// key, {"value": 0.093}, and where the schema allows only a number there, that number. A unit that
/// is not one of the key's gives a fault of `file`.
void take_stated_units(nlohmann::json& document, const nlohmann::json& schema,
                       const std::string& file, std::vector<Fault>& faults);

}  // namespace torquewright::io
