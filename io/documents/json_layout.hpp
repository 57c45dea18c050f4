// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace torquewright::io {

/// A document for people: objects and lists that fit into a line of 100 characters stand on one,
/// others have a line for each member. A line break at its end.
std::string json_layout(const nlohmann::ordered_json& document);

}  // namespace torquewright::io
