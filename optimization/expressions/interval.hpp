// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace torquewright::optimization {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Closed interval of reals, outward rounded: the true result of an operation on any members lies
/// inside the result. [NaN, NaN] is the result of a function outside its domain; every comparison
/// with it is false.
struct Interval {
  double lower = 0.0;
  double upper = 0.0;

  Interval() = default;
  Interval(double value) : lower(value), upper(value) {}  // NOLINT: a number is an interval
  Interval(double low, double high) : lower(low), upper(high) {}

  bool contains(double value) const { return lower <= value && value <= upper; }
  double middle() const { return lower + 0.5 * (upper - lower); }
};

Interval operator-(Interval a);
Interval operator+(Interval a, Interval b);
Interval operator-(Interval a, Interval b);
Interval operator*(Interval a, Interval b);
/// Quotient; the whole line where b contains zero.
Interval operator/(Interval a, Interval b);

Interval square(Interval a);
/// a^2 / b for b > 0; the whole line otherwise.
Interval square_over(Interval a, Interval b);
/// Functions with a domain work on the part of the argument that lies in it.
Interval sqrt(Interval a);
Interval asin(Interval a);
Interval acos(Interval a);
Interval atan(Interval a);
Interval abs(Interval a);
Interval min(Interval a, Interval b);
Interval max(Interval a, Interval b);

/// Intersection; [NaN, NaN] if it is empty.
Interval intersect(Interval a, Interval b);

}  // namespace torquewright::optimization
