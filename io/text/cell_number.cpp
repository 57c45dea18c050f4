// SPDX-License-Identifier: Apache-2.0
#include "io/text/cell_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

namespace torquewright::io {
namespace {

/// Whether a decimal number other than 0 is less than 1 in magnitude: the place of its first digit
/// that counts, and its exponent. A mantissa of 500 zeros is a power of ten as well as "e500" is.
bool is_below_one(std::string_view text) {
  const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, mark);
  const auto first = static_cast<std::int64_t>(mantissa.find_first_of("123456789"));
  const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), mantissa.size()));
  std::int64_t exponent = 0;
  if (mark != text.size()) {
    std::string_view digits = text.substr(mark + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (parsed.ec != std::errc()) return digits.starts_with('-');  // beyond all digits of a line
  }
  return exponent < (first < point ? first - point + 1 : first - point);
}

/// 1.5D-3, as Fortran writes exponents, where a number ended before that letter.
std::optional<double> of_fortran(std::string_view text, const char* letter) {
  const auto at = static_cast<std::size_t>(letter - text.data());
  if (at == 0 || at >= text.size() || (text[at] != 'D' && text[at] != 'd')) return std::nullopt;
  std::string usual(text);
  usual[at] = 'e';
  return number_of(usual);
}

}  // namespace

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (rest != end || text.empty()) return of_fortran(text, rest);
  if (error == std::errc::result_out_of_range) return is_below_one(text) ? 0.0 : HUGE_VAL;
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::string with_point(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == text.npos) return "";
  std::string pointed(text);
  pointed[comma] = '.';
  return number_of(pointed) ? pointed : "";
}

}  // namespace torquewright::io
