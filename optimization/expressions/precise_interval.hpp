// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mpfi.h>

#include "io/text/rational.hpp"
#include "optimization/expressions/interval.hpp"

namespace torquewright::optimization {

/// Outward-rounded interval of 256 bits (MPFI): decides what doubles cannot. Two exact fractions of
/// the size that documents allow, or an angle and a fraction, differ by far more than 2^-200 unless
/// they are equal: an interval of that width that contains zero is taken for zero.
class PreciseInterval {
 public:
  PreciseInterval();
  PreciseInterval(double value);  // NOLINT: a number is an interval
  explicit PreciseInterval(const io::Rational& value);
  PreciseInterval(const PreciseInterval& lower_of, const PreciseInterval& upper_of);
  PreciseInterval(const PreciseInterval& other);
  PreciseInterval& operator=(const PreciseInterval& other);
  ~PreciseInterval();

  static PreciseInterval pi();

  /// Returns the interval of doubles around it.
  Interval outward() const;
  double nearest() const;
  bool is_nowhere() const;   ///< Whether a function was evaluated outside its domain.
  bool is_positive() const;  ///< Every member is above zero.
  bool is_negative() const;

  friend PreciseInterval operator-(const PreciseInterval& a);
  friend PreciseInterval operator+(const PreciseInterval& a, const PreciseInterval& b);
  friend PreciseInterval operator-(const PreciseInterval& a, const PreciseInterval& b);
  friend PreciseInterval operator*(const PreciseInterval& a, const PreciseInterval& b);
  friend PreciseInterval operator/(const PreciseInterval& a, const PreciseInterval& b);
  friend PreciseInterval square(const PreciseInterval& a);
  friend PreciseInterval square_over(const PreciseInterval& a, const PreciseInterval& b);
  friend PreciseInterval sqrt(const PreciseInterval& a);
  friend PreciseInterval sin(const PreciseInterval& a);
  friend PreciseInterval cos(const PreciseInterval& a);
  friend PreciseInterval tan(const PreciseInterval& a);
  friend PreciseInterval asin(const PreciseInterval& a);
  friend PreciseInterval acos(const PreciseInterval& a);
  friend PreciseInterval atan(const PreciseInterval& a);
  friend PreciseInterval abs(const PreciseInterval& a);
  friend PreciseInterval min(const PreciseInterval& a, const PreciseInterval& b);
  friend PreciseInterval max(const PreciseInterval& a, const PreciseInterval& b);

 private:
  mpfi_t value_;
};

}  // namespace torquewright::optimization
