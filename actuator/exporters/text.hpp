// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torquewright::actuator {

/// Pieces of the files that are written, safe whatever the actuator is called.

/// Lines behind a mark ("# ", "// ").
std::string line_comment(const std::vector<std::string>& lines, std::string_view mark);

/// <!-- ... -->, in which no two hyphens may meet.
std::string xml_comment(const std::vector<std::string>& lines);

/// In quotes, as the value of an XML attribute.
std::string xml_quoted(std::string_view text);

/// A name that C++, Python and USD accept: other characters become underscores.
std::string identifier(std::string_view text);

}  // namespace torquewright::actuator
