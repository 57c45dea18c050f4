// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "io/faults/json_text.hpp"

namespace torquewright::io {

/// Reads strict JSON in UTF-8, with or without a byte order mark.
JsonText read_json_text(std::string_view text, const std::string& file);

}  // namespace torquewright::io
