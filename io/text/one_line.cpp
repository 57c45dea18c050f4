// SPDX-License-Identifier: Apache-2.0
#include "io/text/one_line.hpp"

#include <fmt/format.h>

#include "io/text/utf8.hpp"

namespace torquewright::io {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// What ends a line, moves a terminal's cursor, or turns the order of the text around it.
bool is_control(std::uint32_t c) {
  const bool is_c0_or_c1 = c < 0x20 || (c >= 0x7F && c <= 0x9F);
  const bool ends_line = c == 0x2028 || c == 0x2029;
  const bool turns = (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
  return is_c0_or_c1 || ends_line || turns;
}

bool is_printable(const Utf8Part& part) {
  return part.is_character && !is_control(part.code_point) && part.code_point != 0xFFFE &&
         part.code_point != 0xFFFF;
}

}  // namespace

std::optional<std::string> unprintable_in(std::string_view text) {
  while (!text.empty()) {
    const Utf8Part part = first_utf8_part(text);
    if (!part.is_character) {
      return fmt::format("the byte 0x{:02X}, which is not UTF-8",
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
    const Utf8Part part = first_utf8_part(text);
    line += is_printable(part) ? text.substr(0, part.bytes) : kReplacement;
    text.remove_prefix(part.bytes);
  }
  return line;
}

std::string name_in_text(const std::filesystem::path& file) { return one_line(file.native()); }

std::string stem_in_text(const std::filesystem::path& file) {
  return name_in_text(file.extension() == ".gz" ? file.stem().stem() : file.stem());
}

}  // namespace torquewright::io
