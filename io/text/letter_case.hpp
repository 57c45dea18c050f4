// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace torquewright::io {

/// Returns the word in small letters; letters beyond ASCII stay as they are.
std::string in_small_letters(std::string word);

/// Writes words of which a schema lists the allowed ones as they are listed, where they differ in
/// capitals alone: "3K" becomes "3k".
void take_listed_capitals(nlohmann::json& document, const nlohmann::json& schema);

}  // namespace torquewright::io
