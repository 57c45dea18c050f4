// SPDX-License-Identifier: Apache-2.0
#include "tests/optimization/true_values.hpp"

#include <mpfr.h>

#include <cmath>

namespace torquewright::optimization {
namespace {

constexpr mpfr_prec_t kBits = 400;

Rational evaluate(int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), const Rational& a) {
  mpfr_t value;
  mpfr_init2(value, kBits);
  mpfr_set_q(value, a.get_mpq_t(), MPFR_RNDN);
  function(value, value, MPFR_RNDN);
  Rational result;
  mpfr_get_q(result.get_mpq_t(), value);
  mpfr_clear(value);
  return result;
}

}  // namespace

Rational true_sqrt(const Rational& a) { return evaluate(mpfr_sqrt, a); }
Rational true_sin(const Rational& a) { return evaluate(mpfr_sin, a); }
Rational true_cos(const Rational& a) { return evaluate(mpfr_cos, a); }
Rational true_tan(const Rational& a) { return evaluate(mpfr_tan, a); }
Rational true_asin(const Rational& a) { return evaluate(mpfr_asin, a); }
Rational true_acos(const Rational& a) { return evaluate(mpfr_acos, a); }
Rational true_atan(const Rational& a) { return evaluate(mpfr_atan, a); }
Rational true_pi() { return 4 * true_atan(1); }

bool encloses(const Interval& interval, const Rational& value) {
  if (is_nowhere(interval)) return false;
  const bool above = interval.lower == -HUGE_VAL ||
                     (std::isfinite(interval.lower) && Rational(interval.lower) <= value);
  const bool below = interval.upper == HUGE_VAL ||
                     (std::isfinite(interval.upper) && value <= Rational(interval.upper));
  return above && below;
}

bool agrees(const PreciseInterval& interval, const Rational& value) {
  const Interval error = (interval - PreciseInterval(value)).outward();
  const double size = std::max(1.0, std::abs(value.get_d()));
  return error.contains(0.0) && error.upper - error.lower < size * 0x1p-240;
}

bool is_nowhere(const Interval& interval) {
  return std::isnan(interval.lower) || std::isnan(interval.upper);
}

}  // namespace torquewright::optimization
