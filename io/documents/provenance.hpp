// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

namespace torquewright::io {

struct Document;

/// The version of this build, as in CMakeLists.txt.
std::string_view tool_version();

/// {"name": "torquewright", "version": ...}: the "tool" of a result.
nlohmann::json tool_provenance();

/// [{"path", "sha256"}, ...]: the "inputs" of a result, in the order they were read.
nlohmann::json input_provenance(std::span<const Document> documents);

}  // namespace torquewright::io
