// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mpfi.h>

#include <cstdint>

#include "io/text/rational.hpp"

namespace torquewright::gearbox::proof {

using io::Rational;

/// A set of real numbers between two ends of 256 bits, rounded outward by every operation. An
/// operation outside its domain (a division by an interval that holds zero, a root of a negative
/// number) gives an unbounded or undefined interval, about which nothing is certain.
/// The search has its own (optimization/expressions/precise_interval.hpp), which a checker of its
/// proofs must not trust: docs/decisions/0001-checker-knows-topologies.md.
class Interval {
 public:
  Interval() : Interval(0L) {}
  Interval(long value);                                        // NOLINT: numbers are intervals
  Interval(int value) : Interval(static_cast<long>(value)) {}  // NOLINT
  Interval(const Rational& value);                             // NOLINT
  /// The interval from `low` to `high`; requires low <= high.
  Interval(const Rational& low, const Rational& high);
  Interval(const Interval& other);
  Interval(Interval&& other) noexcept;
  Interval& operator=(Interval other) noexcept;
  ~Interval();

  Interval& operator+=(const Interval& other);
  Interval& operator-=(const Interval& other);
  Interval& operator*=(const Interval& other);
  Interval& operator/=(const Interval& other);
  Interval operator-() const;

  friend Interval operator+(Interval a, const Interval& b) { return a += b; }
  friend Interval operator-(Interval a, const Interval& b) { return a -= b; }
  friend Interval operator*(Interval a, const Interval& b) { return a *= b; }
  friend Interval operator/(Interval a, const Interval& b) { return a /= b; }

  bool is_defined() const;
  bool certainly_positive() const;  ///< Every number in it exceeds zero.
  bool certainly_negative() const;

  Interval lower() const;  ///< Its left end.
  Interval upper() const;  ///< Its right end.

  double least_double() const;     ///< The greatest double that is no greater than its left end.
  double greatest_double() const;  ///< The least double that is no less than its right end.

  friend Interval sqrt(const Interval& x);
  friend Interval square(const Interval& x);
  friend Interval abs(const Interval& x);
  friend Interval sin(const Interval& x);
  friend Interval cos(const Interval& x);
  friend Interval tan(const Interval& x);
  friend Interval asin(const Interval& x);
  friend Interval acos(const Interval& x);
  friend Interval min(const Interval& a, const Interval& b);
  friend Interval max(const Interval& a, const Interval& b);
  friend Interval hull(const Interval& a, const Interval& b);
  /// What both hold; `a` where they hold nothing in common.
  friend Interval intersection(const Interval& a, const Interval& b);

 private:
  mpfi_t value_;
};

/// Tooth counts, as a fraction and as an interval.
inline Rational whole(std::int64_t value) { return Rational(static_cast<long>(value)); }
template <typename Number = Interval>
Number number(std::int64_t value) {
  return Number(static_cast<long>(value));
}

Interval sqrt(const Interval& x);
Interval square(const Interval& x);
Interval abs(const Interval& x);
Interval sin(const Interval& x);
Interval cos(const Interval& x);
Interval tan(const Interval& x);
Interval asin(const Interval& x);
Interval acos(const Interval& x);
Interval min(const Interval& a, const Interval& b);
Interval max(const Interval& a, const Interval& b);
Interval hull(const Interval& a, const Interval& b);
Interval intersection(const Interval& a, const Interval& b);

const Interval& pi();

/// -1, 0 or 1 of a number known to 256 bits; 0 also where those cannot tell. The numbers judged so
/// are differences of sines, roots and fractions of at most 7-digit teeth and 17-digit decimals.
/// They are either exactly zero (sin 30 degrees is one half) or, being algebraic of low degree or
/// removed from such by pi, further from zero than 2^-200: no accident brings them closer.
int sign(const Interval& x);

}  // namespace torquewright::gearbox::proof
