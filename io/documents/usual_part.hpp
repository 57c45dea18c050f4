// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace torquewright::io {

/// What the pointers name of a document, with all that stands below it, in the document's order; *
/// stands for each entry of a list, or for any key. Kind and version stay, and of "assumed" the
/// pointers to what stays.
nlohmann::ordered_json usual_part(const nlohmann::ordered_json& document,
                                  const std::vector<std::string>& pointers);

/// Whether a value stands at the pointer, in which * stands for any entry or key.
bool stands_in(const nlohmann::ordered_json& document, const std::string& pointer);

}  // namespace torquewright::io
