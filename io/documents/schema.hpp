// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::io {

/// The kinds of documents, one file each in specs/schema (compiled in), in alphabetical order.
std::vector<std::string> document_kinds();

/// The JSON Schema (draft 7) of a kind; a "$ref" to another kind's file is replaced by that file.
/// Requires a known kind.
const nlohmann::json& schema_of(std::string_view kind);

/// The same with its "$id" and "examples", its keys in the order in which they were written.
nlohmann::ordered_json schema_as_written(std::string_view kind);

/// True if the document satisfies the schema of that kind. Requires a known kind.
bool conforms(const nlohmann::json& document, std::string_view kind);

}  // namespace torquewright::io
