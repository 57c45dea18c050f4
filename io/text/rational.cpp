// SPDX-License-Identifier: Apache-2.0
#include "io/text/rational.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace torquewright::io {
namespace {

/// Beyond any double, and small enough that the power of ten stays a small number.
constexpr long kMaxExponent = 1000;

[[noreturn]] void refuse_numeral(std::string_view numeral) {
  throw std::invalid_argument("not a JSON number: " + std::string(numeral.substr(0, 40)));
}

/// Takes the leading digits off `rest`; at least one has to be there.
std::string take_digits(std::string_view& rest, std::string_view numeral) {
  std::size_t count = 0;
  while (count < rest.size() && rest[count] >= '0' && rest[count] <= '9') ++count;
  if (count == 0) refuse_numeral(numeral);
  std::string digits(rest.substr(0, count));
  rest.remove_prefix(count);
  return digits;
}

bool take(std::string_view& rest, std::string_view any_of) {
  if (rest.empty() || any_of.find(rest.front()) == std::string_view::npos) return false;
  rest.remove_prefix(1);
  return true;
}

long take_exponent(std::string_view& rest, std::string_view numeral) {
  const bool negative = !rest.empty() && rest.front() == '-';
  take(rest, "+-");
  const std::string digits = take_digits(rest, numeral);
  long exponent = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  if (parsed.ec != std::errc() || exponent > kMaxExponent) refuse_numeral(numeral);
  return negative ? -exponent : exponent;
}

mpz_class power_of_ten(unsigned long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
  return power;
}

}  // namespace

Rational exact(double value) {
  std::array<char, 32> numeral;
  // Scientific: the plain form writes out all digits of a large whole double, not the fewest.
  const auto end = std::to_chars(numeral.data(), numeral.data() + numeral.size(), value,
                                 std::chars_format::scientific)
                       .ptr;
  // "inf" and "nan" are no numerals, so they are refused there.
  return rational_from_numeral({numeral.data(), static_cast<std::size_t>(end - numeral.data())});
}

Rational rational_from_numeral(std::string_view numeral) {
  std::string_view rest = numeral;
  const bool negative = take(rest, "-");
  std::string digits = take_digits(rest, numeral);
  if (digits.size() > 1 && digits.front() == '0') refuse_numeral(numeral);
  long exponent = 0;
  if (take(rest, ".")) {
    const std::string decimals = take_digits(rest, numeral);
    digits += decimals;
    exponent -= static_cast<long>(decimals.size());
  }
  if (take(rest, "eE")) exponent += take_exponent(rest, numeral);
  if (!rest.empty()) refuse_numeral(numeral);

  Rational value{mpz_class(digits, 10)};
  const mpz_class scale = power_of_ten(static_cast<unsigned long>(std::abs(exponent)));
  if (exponent < 0) {
    value /= scale;
  } else {
    value *= scale;
  }
  return negative ? Rational(-value) : value;
}

double nearest(const Rational& value) {
  const double inner = value.get_d();
  if (!std::isfinite(inner)) return inner;
  const double outer = std::nextafter(inner, std::copysign(HUGE_VAL, sgn(value)));
  if (!std::isfinite(outer)) return inner;
  const int order = cmp(abs(Rational(outer) - value), abs(value - Rational(inner)));
  const bool inner_is_odd = (std::bit_cast<std::uint64_t>(inner) & 1u) != 0;
  return order < 0 || (order == 0 && inner_is_odd) ? outer : inner;
}

}  // namespace torquewright::io
