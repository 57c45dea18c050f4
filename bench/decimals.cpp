// SPDX-License-Identifier: Apache-2.0
#include "bench/decimals.hpp"

#include <stdexcept>

namespace torquewright::bench {

io::Rational from_decimal(const std::string& text) {
  const std::size_t point = text.find('.');
  const std::size_t places = point == std::string::npos ? 0 : text.size() - point - 1;
  std::string digits = text;
  if (point != std::string::npos) digits.erase(point, 1);
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, places);
  return io::Rational(mpz_class(digits, 10)) / scale;
}

std::string to_decimal(const io::Rational& value) {
  mpz_class scaled = value.get_num();
  for (std::size_t places = 0; places <= 15; ++places, scaled *= 10) {
    if (!mpz_divisible_p(scaled.get_mpz_t(), value.get_den_mpz_t())) continue;
    std::string digits = mpz_class(abs(scaled) / value.get_den()).get_str();
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    if (places > 0) digits.insert(digits.size() - places, 1, '.');
    return (value < 0 ? "-" : "") + digits;
  }
  throw std::invalid_argument(value.get_str() + " is no short decimal");
}

}  // namespace torquewright::bench
