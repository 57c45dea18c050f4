// SPDX-License-Identifier: Apache-2.0
// UTF-8 as RFC 3629 and Unicode 15 (table 3-7) have it: neither overlong forms nor surrogates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace torquewright::io {

/// A character, or the bytes that begin one and break off (at least one byte).
struct Utf8Part {
  std::size_t bytes = 1;
  bool is_character = false;
  std::uint32_t code_point = 0;  ///< Where it is a character.
};

/// `text` must not be empty.
Utf8Part first_utf8_part(std::string_view text);

/// Where the first part begins that is no character; npos where all of it is UTF-8.
std::size_t first_that_is_no_utf8(std::string_view text);

/// Text of ISO 8859-1, whose bytes are the first 256 code points, in UTF-8.
std::string utf8_of_latin1(std::string_view text);

}  // namespace torquewright::io
