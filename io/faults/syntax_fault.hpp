// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace torquewright::io {

/// "line 2, column 5" of the last of the first `position` bytes; columns count characters.
std::string line_and_column(std::string_view text, std::size_t position);

/// Why a text is no JSON, as a sentence with line and column.
struct SyntaxFault {
  bool is_at_value;  ///< The text is well formed up to a number that is none: its path is known.
  std::string message;
};

/// Translates what nlohmann's parser reports: `position` bytes were read when it stopped, at the
/// text `last_token`.
SyntaxFault syntax_fault(std::string_view text, std::size_t position, std::string_view last_token,
                         const nlohmann::json::exception& error);

}  // namespace torquewright::io
