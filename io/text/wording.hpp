// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace torquewright::io {

/// A value as it stands in the document, long ones cut off: 0.5, "4k", null, [...].
std::string as_written(const nlohmann::json& value);

/// "a string", "a number", "a list", ...: what a value is.
std::string type_name(const nlohmann::json& value);

/// What a schema's node asks for: "a number", "a list of whole numbers", "a string or null".
std::string expected_type(const nlohmann::json& schema);

/// True if the value is of (one of) the schema node's "type"; a node without one takes any.
bool has_expected_type(const nlohmann::json& value, const nlohmann::json& schema);

/// Joins words as a list: "a, b, c".
std::string listed(const std::vector<std::string>& words);

/// Joins words as a choice: "a, b or c".
std::string either(const std::vector<std::string>& words);

}  // namespace torquewright::io
