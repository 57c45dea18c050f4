// SPDX-License-Identifier: Apache-2.0
#include "io/one_line.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace torquewright::io {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// The next of a text's parts: a character, or bytes that are none.
struct Part {
  std::size_t bytes = 1;
  bool is_utf8 = false;
  std::uint32_t code_point = 0;  ///< Where it is UTF-8.
};

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

Part first_part(std::string_view text) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {1, true, lead};
  if (lead < 0xC2 || lead > 0xF4) return {};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  Part part{1, false, lead & (0x7FU >> length)};
  Continuation allowed = second_byte(lead);
  for (; part.bytes < length; ++part.bytes, allowed = {}) {
    if (part.bytes == text.size()) return part;
    const unsigned next = byte(part.bytes);
    if (next < allowed.lowest || next > allowed.highest) return part;
    part.code_point = part.code_point << 6U | (next & 0x3FU);
  }
  part.is_utf8 = true;
  return part;
}

bool is_printable(const Part& part) {
  return part.is_utf8 && part.code_point >= 0x20 && part.code_point != 0x7F &&
         part.code_point != 0xFFFE && part.code_point != 0xFFFF;
}

}  // namespace

std::optional<std::string> unprintable_in(std::string_view text) {
  while (!text.empty()) {
    const Part part = first_part(text);
    if (!part.is_utf8) {
      return fmt::format("the byte 0x{:02X}, which is no UTF-8",
                         static_cast<unsigned char>(text.front()));
    }
    if (!is_printable(part)) return fmt::format("the character U+{:04X}", part.code_point);
    text.remove_prefix(part.bytes);
  }
  return std::nullopt;
}

std::string one_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const Part part = first_part(text);
    line += is_printable(part) ? text.substr(0, part.bytes) : kReplacement;
    text.remove_prefix(part.bytes);
  }
  return line;
}

std::string name_in_text(const std::filesystem::path& file) { return one_line(file.native()); }

std::string stem_in_text(const std::filesystem::path& file) { return name_in_text(file.stem()); }

}  // namespace torquewright::io
