// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/fractions.hpp"

#include <stdexcept>

namespace torquewright::oracles {

Fraction narrow(const Rational& value) {
  if (!value.get_num().fits_slong_p() || !value.get_den().fits_slong_p()) {
    throw std::invalid_argument("the oracle takes fractions of at most 63 bits: " +
                                value.get_str());
  }
  return {value.get_num().get_si(), value.get_den().get_si()};
}

long double to_long_double(const Rational& value) {
  const Fraction fraction = narrow(value);
  return static_cast<long double>(fraction.numerator) /
         static_cast<long double>(fraction.denominator);
}

std::int64_t floor_of(const Rational& value) {
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  if (!quotient.fits_slong_p()) throw std::overflow_error("floor of " + value.get_str());
  return quotient.get_si();
}

int compare(Wide p, Wide q, const Fraction& limit) {
  const Wide left = p * limit.denominator;
  const Wide right = q * limit.numerator;
  return (left > right) - (left < right);
}

Wide floor_divide(Wide dividend, Wide divisor) {
  const Wide quotient = dividend / divisor;
  return dividend % divisor < 0 ? quotient - 1 : quotient;
}

Wide ceil_divide(Wide dividend, Wide divisor) { return -floor_divide(-dividend, divisor); }

}  // namespace torquewright::oracles
