// SPDX-License-Identifier: Apache-2.0
#include "io/faults/syntax_fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace torquewright::io {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr int kNumberOverflow = 406;  // nlohmann's id of "number overflow parsing ..."

bool is_continuation_byte(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// `NaN` or `Infinity` where the last character read begins it; many writers emit them.
std::string_view foreign_number(std::string_view text, std::size_t position) {
  if (position == 0 || position > text.size()) return {};
  for (const std::string_view word : {"NaN", "Infinity"}) {
    if (text.substr(position - 1).starts_with(word)) return word;
  }
  return {};
}

/// `0,32` where the last character read ends a number behind a comma.
bool is_decimal_comma(std::string_view text, std::size_t position) {
  const auto is_digit = [&](std::size_t at) { return text[at] >= '0' && text[at] <= '9'; };
  if (position == 0 || position > text.size()) return false;
  const std::size_t comma = text.find_last_of(',', position - 1);
  return comma != std::string_view::npos && comma > 0 && comma + 1 < text.size() &&
         is_digit(comma - 1) && is_digit(comma + 1);
}

/// The parser's reason without its exception id, position and copy of the text.
std::string reason(std::string text) {
  const std::size_t start = text.find(" - ");
  if (start != std::string::npos) text.erase(0, start + 3);
  const std::size_t copy = text.find("; last read: '");
  if (copy == std::string::npos) return text;
  const std::size_t copy_end = text.rfind("'; expected ");
  const bool goes_on = copy_end != std::string::npos && copy_end > copy;
  return text.erase(copy, goes_on ? copy_end + 1 - copy : std::string::npos);
}

}  // namespace

std::string line_and_column(std::string_view text, std::size_t position) {
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
    position -= std::min(position, kByteOrderMark.size());
  }
  const std::string_view read = text.substr(0, std::max<std::size_t>(position, 1) - 1);
  const auto lines = std::count(read.begin(), read.end(), '\n');
  const std::size_t line_start = read.find_last_of('\n') + 1;  // npos + 1 is 0
  const std::string_view line = read.substr(line_start);
  const auto continued = std::count_if(line.begin(), line.end(), is_continuation_byte);
  const auto column = static_cast<std::ptrdiff_t>(line.size()) - continued + 1;
  return fmt::format("line {}, column {}", lines + 1, column);
}

SyntaxFault syntax_fault(std::string_view text, std::size_t position, std::string_view last_token,
                         const nlohmann::json::exception& error) {
  const std::string where = line_and_column(text, position);
  if (error.id == kNumberOverflow) {
    return {true,
            fmt::format("{} is too large for a number ({})", last_token.substr(0, 40), where)};
  }
  if (const std::string_view word = foreign_number(text, position); !word.empty()) {
    return {true, fmt::format("{} is not a JSON number, must be finite ({})", word, where)};
  }
  const std::string why = reason(error.what());
  if (why.find("ill-formed UTF-8") != std::string::npos) return {false, where + ": not UTF-8"};
  if (why.find("unexpected number literal") != std::string::npos &&
      is_decimal_comma(text, position)) {
    return {false, where + ": not JSON: a decimal comma? write 1.5, not 1,5"};
  }
  return {false, where + ": not JSON: " + why};
}

}  // namespace torquewright::io
