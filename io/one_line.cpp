// SPDX-License-Identifier: Apache-2.0
#include "io/one_line.hpp"

#include <fmt/format.h>

#include "io/utf8.hpp"

namespace torquewright::io {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

bool is_printable(const Utf8Part& part) {
  return part.is_character && part.code_point >= 0x20 && part.code_point != 0x7F &&
         part.code_point != 0xFFFE && part.code_point != 0xFFFF;
}

}  // namespace

std::optional<std::string> unprintable_in(std::string_view text) {
  while (!text.empty()) {
    const Utf8Part part = first_utf8_part(text);
    if (!part.is_character) {
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
    const Utf8Part part = first_utf8_part(text);
    line += is_printable(part) ? text.substr(0, part.bytes) : kReplacement;
    text.remove_prefix(part.bytes);
  }
  return line;
}

std::string name_in_text(const std::filesystem::path& file) { return one_line(file.native()); }

std::string stem_in_text(const std::filesystem::path& file) { return name_in_text(file.stem()); }

}  // namespace torquewright::io
