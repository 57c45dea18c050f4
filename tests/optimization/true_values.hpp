// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/text/rational.hpp"
#include "optimization/expressions/precise_interval.hpp"

namespace torquewright::optimization {

using io::Rational;

/// Oracle: MPFR, rounded to nearest at 400 bits, which is exact for all that is asked of it here.
Rational true_sqrt(const Rational& a);
Rational true_sin(const Rational& a);
Rational true_cos(const Rational& a);
Rational true_tan(const Rational& a);
Rational true_asin(const Rational& a);
Rational true_acos(const Rational& a);
Rational true_atan(const Rational& a);
Rational true_pi();

/// Compares fractions, so nothing is rounded. Infinite ends enclose, NaN does not.
bool encloses(const Interval& interval, const Rational& value);

/// The value lies inside, and the interval is narrower than 2^-240 of the value (of 1, if smaller).
bool agrees(const PreciseInterval& interval, const Rational& value);

bool is_nowhere(const Interval& interval);

}  // namespace torquewright::optimization
