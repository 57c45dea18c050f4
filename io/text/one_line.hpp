// SPDX-License-Identifier: Apache-2.0
// Text that every output can hold: a table's comment, a page, XML 1.0 (2.2, Char), a program's
// source. That is one line of UTF-8 without control characters, U+FFFE and U+FFFF.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace torquewright::io {

/// What a text holds first that such a line cannot: "the character U+000A", "the byte 0xE9, which
/// is not UTF-8".
std::optional<std::string> unprintable_in(std::string_view text);

/// The text with U+FFFD for each such character, and for each part that is no UTF-8.
std::string one_line(std::string_view text);

/// A file's name, which is bytes, as text.
std::string name_in_text(const std::filesystem::path& file);

/// The same of the name without its folder and its ending, as things are called that have no name.
std::string stem_in_text(const std::filesystem::path& file);

}  // namespace torquewright::io
