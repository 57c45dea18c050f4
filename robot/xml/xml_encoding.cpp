// SPDX-License-Identifier: Apache-2.0
// Rules: XML 1.0, 2.8 and 4.3.3.
#include "robot/xml/xml_encoding.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/text/letter_case.hpp"
#include "io/text/utf8.hpp"

namespace torquewright::hopper {
namespace {

bool is_ascii(char character) { return static_cast<unsigned char>(character) < 0x80; }

long line_at(std::string_view text, std::size_t place) {
  return 1 + std::count(text.begin(), text.begin() + static_cast<long>(place), '\n');
}

}  // namespace

std::string declared_encoding(std::string_view declaration) {
  const std::size_t key = declaration.find("encoding");
  if (key == std::string_view::npos) return "";
  const std::size_t open = declaration.find_first_of("'\"", key);
  if (open == std::string_view::npos) return "";
  const std::size_t close = declaration.find(declaration[open], open + 1);
  if (close == std::string_view::npos) return "";
  return std::string(declaration.substr(open + 1, close - open - 1));
}

std::optional<std::string> encoding_objection(std::string_view text, std::string_view declared) {
  const auto foreign =
      std::find_if(text.begin(), text.end(), [](char next) { return !is_ascii(next); });
  if (foreign == text.end()) return std::nullopt;
  const std::string encoding = io::in_small_letters(std::string(declared));
  if (!encoding.empty() && encoding != "utf-8" && encoding != "utf8") {
    return fmt::format(
        "line 1: encoding=\"{}\" is not read, and line {} holds letters beyond ASCII; convert the "
        "file to UTF-8: iconv -f {} -t utf-8",
        declared, line_at(text, static_cast<std::size_t>(foreign - text.begin())), declared);
  }
  const std::size_t place = io::first_that_is_no_utf8(text);
  if (place == std::string_view::npos) return std::nullopt;
  return fmt::format(
      "line {}: is not UTF-8, which XML is where it states nothing else; convert the file: iconv "
      "-f "
      "latin1 -t utf-8",
      line_at(text, place));
}

}  // namespace torquewright::hopper
