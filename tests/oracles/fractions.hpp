// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "io/text/rational.hpp"

namespace torquewright::oracles {

using io::Rational;

__extension__ using Wide = __int128;

/// A fraction that fits machine integers, so that the innermost loop compares without allocating.
struct Fraction {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;  ///< Above 0.
};

/// Throws std::invalid_argument where numerator or denominator exceeds 63 bits.
Fraction narrow(const Rational& value);

/// The nearest long double (64 bits of mantissa), to one rounding. Throws as narrow() does.
long double to_long_double(const Rational& value);

/// The greatest integer not above the value. Throws std::overflow_error beyond 63 bits.
std::int64_t floor_of(const Rational& value);

/// Sign of p/q - limit for q > 0, exactly: -1, 0 or 1.
int compare(Wide p, Wide q, const Fraction& limit);

/// Quotients of integers rounded towards minus and plus infinity, for divisor > 0.
Wide floor_divide(Wide dividend, Wide divisor);
Wide ceil_divide(Wide dividend, Wide divisor);

}  // namespace torquewright::oracles
