// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/printed_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

namespace torquewright::cli {
namespace {

bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }

std::size_t digits_at(std::string_view text, std::size_t from) {
  const auto* begin = text.begin() + std::min(from, text.size());
  return static_cast<std::size_t>(
      std::distance(begin, std::find_if_not(begin, text.end(), is_digit)));
}

void replace_all(std::string& text, std::string_view printed, std::string_view here) {
  for (std::size_t at = text.find(printed); at != text.npos; at = text.find(printed, at)) {
    text.replace(at, printed.size(), here);
  }
}

/// Blanks that no keyboard has, the signs of a product and the raised figures of a power.
std::string in_plain_signs(std::string_view printed) {
  static constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
      {"\u00a0", " "}, {"\u202f", " "}, {"\u2009", " "}, {"\u2212", "-"}, {"\u2013", "-"},
      {"\u00d7", "x"}, {"\u207b", "-"}, {"\u2070", "0"}, {"\u00b9", "1"}, {"\u2074", "4"},
      {"\u2075", "5"}, {"\u2076", "6"}, {"\u2077", "7"}, {"\u2078", "8"}, {"\u2079", "9"}};
  std::string text(printed);
  for (const auto& [sign, plain] : kSigns) replace_all(text, sign, plain);
  return text;
}

/// "3 820" and "3'820" as 3820: groups of three digits behind one to three.
void join_thousands(std::string& text) {
  std::size_t at = digits_at(text, 0);
  if (at < 1 || at > 3) return;
  while (at < text.size() && (text[at] == ' ' || text[at] == '\'') &&
         digits_at(text, at + 1) == 3) {
    text.erase(at, 1);
    at += 3;
  }
}

/// A comma behind the first digits: of decimals, or of thousands, or of either.
std::string fault_of_comma(std::string& text) {
  const std::size_t at = digits_at(text, 0);
  if (at == 0 || at >= text.size() || text[at] != ',') return "";
  const std::size_t behind = digits_at(text, at + 1);
  if (behind == 0) return "";
  const std::size_t next = at + 1 + behind;
  const bool is_of_thousands = next < text.size() && text[next] == '.' && behind == 3;
  if (is_of_thousands) {
    text.erase(at, 1);
    return "";
  }
  if (behind == 3 && at <= 3 && text.front() != '0') {
    return fmt::format("the comma may stand for thousands or for decimals; write {0}{1} or {0}.{1}",
                       text.substr(0, at), text.substr(at + 1, behind));
  }
  text[at] = '.';
  return "";
}

/// " x 10^-5 kg m2" behind a number: the power is taken, the rest left.
int take_power_of_ten(std::string& behind) {
  std::string rest = behind;
  rest.erase(0, rest.find_first_not_of(' '));
  if (rest.empty() || (rest.front() != 'x' && rest.front() != '*')) return 0;
  rest.erase(0, 1);
  rest.erase(0, rest.find_first_not_of(' '));
  if (!rest.starts_with("10")) return 0;
  rest.erase(0, 2);
  if (rest.starts_with('^')) rest.erase(0, 1);
  int power = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), power);
  if (error != std::errc() || std::abs(power) > 30) return 0;
  behind = rest.substr(static_cast<std::size_t>(end - rest.data()));
  return power;
}

/// What follows "24" of "24 - 48 V", "24-48 V", "24~48 V" and "24 to 48 V".
bool is_range(std::string behind) {
  behind.erase(0, behind.find_first_not_of(' '));
  for (const std::string_view mark : {"-", "~", "to ", "..."}) {
    if (!behind.starts_with(mark)) continue;
    const std::string rest = behind.substr(mark.size());
    const std::size_t first = rest.find_first_not_of(' ');
    return first != rest.npos && is_digit(rest[first]);
  }
  return false;
}

}  // namespace

PrintedNumber printed_number(std::string_view printed) {
  std::string text = in_plain_signs(printed);
  PrintedNumber read;
  join_thousands(text);
  read.fault = fault_of_comma(text);
  if (!read.fault.empty()) return read;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, read.number);
  if (error != std::errc() || !std::isfinite(read.number)) {
    read.fault = "it does not begin with a number";
    return read;
  }
  read.behind = std::string(rest, end);
  if (is_range(read.behind)) {
    read.fault = "it is a range; the other numbers hold at one value of it";
    return read;
  }
  const int power = take_power_of_ten(read.behind);
  if (power != 0) read.number = std::stod(fmt::format("{}e{}", read.number, power));
  read.behind.erase(0, read.behind.find_first_not_of(' '));
  return read;
}

}  // namespace torquewright::cli
