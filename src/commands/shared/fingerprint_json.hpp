// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "io/documents/document.hpp"

namespace torquewright::cli {

/// SHA-256 of what an answer depends on: the command, its options, the inputs' own, the program's
/// version.
std::string fingerprint(std::string_view command, const nlohmann::ordered_json& options,
                        std::span<const io::Document> inputs);

}  // namespace torquewright::cli
