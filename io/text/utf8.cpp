// SPDX-License-Identifier: Apache-2.0
#include "io/text/utf8.hpp"

namespace torquewright::io {
namespace {

/// What the second byte of a character may be, by its first (Unicode 15, table 3-7); others follow
/// from 0x80 to 0xBF.
struct Continuation {
  unsigned lowest = 0x80, highest = 0xBF;
};

Continuation second_byte(unsigned lead) {
  if (lead == 0xE0) return {0xA0, 0xBF};
  if (lead == 0xED) return {0x80, 0x9F};  // surrogates are no characters
  if (lead == 0xF0) return {0x90, 0xBF};
  if (lead == 0xF4) return {0x80, 0x8F};
  return {};
}

}  // namespace

Utf8Part first_utf8_part(std::string_view text) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {1, true, lead};
  if (lead < 0xC2 || lead > 0xF4) return {};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  Utf8Part part{1, false, lead & (0x7FU >> length)};
  Continuation allowed = second_byte(lead);
  for (; part.bytes < length; ++part.bytes, allowed = {}) {
    if (part.bytes == text.size()) return part;
    const unsigned next = byte(part.bytes);
    if (next < allowed.lowest || next > allowed.highest) return part;
    part.code_point = part.code_point << 6U | (next & 0x3FU);
  }
  part.is_character = true;
  return part;
}

std::size_t first_that_is_no_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const Utf8Part part = first_utf8_part(text.substr(at));
    if (!part.is_character) return at;
    at += part.bytes;
  }
  return std::string_view::npos;
}

std::string utf8_of_latin1(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    const auto point = static_cast<unsigned char>(letter);
    if (point < 0x80) {
      result += letter;
    } else {
      result += static_cast<char>(0xC0U | point >> 6U);
      result += static_cast<char>(0x80U | (point & 0x3FU));
    }
  }
  return result;
}

}  // namespace torquewright::io
