// SPDX-License-Identifier: Apache-2.0
#include "optimization/expressions/interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::optimization {
namespace {

constexpr double kGreatest = std::numeric_limits<double>::max();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Basic operations round to nearest, an error of half a unit in the last place (2^-53 relative);
// four times that also covers the rounding of the correction itself. The least normal number covers
// underflow. Infinity is what overflows: the true value may be any number beyond the greatest
// double.
double down(double value) {
  if (std::isfinite(value)) return value - (std::abs(value) * 0x1p-51 + 0x1p-1022);
  return value > 0.0 ? kGreatest : value;
}
double up(double value) { return -down(-value); }

// glibc states at most 1 unit in the last place for these functions on this machine's family;
// eight are allowed for.
double down_function(double value) { return value - (std::abs(value) * 0x1p-49 + 0x1p-1022); }
double up_function(double value) { return -down_function(-value); }

const Interval kWholeLine{-kInfinity, kInfinity};
const Interval kNowhere{kNaN, kNaN};

// 0 times infinity is 0 here: an infinite end is a limit that is never reached.
double product(double a, double b) { return a == 0.0 || b == 0.0 ? 0.0 : a * b; }

}  // namespace

Interval operator-(Interval a) { return {-a.upper, -a.lower}; }
Interval operator+(Interval a, Interval b) {
  return {down(a.lower + b.lower), up(a.upper + b.upper)};
}
Interval operator-(Interval a, Interval b) { return a + (-b); }

Interval operator*(Interval a, Interval b) {
  if (a.lower >= 0.0 && b.lower >= 0.0) {
    return {down(product(a.lower, b.lower)), up(product(a.upper, b.upper))};
  }
  if (std::isnan(a.lower) || std::isnan(b.lower)) return kNowhere;
  const double p = product(a.lower, b.lower), q = product(a.lower, b.upper);
  const double r = product(a.upper, b.lower), s = product(a.upper, b.upper);
  return {down(std::min({p, q, r, s})), up(std::max({p, q, r, s}))};
}

Interval operator/(Interval a, Interval b) {
  if (std::isnan(a.lower) || std::isnan(b.lower)) return kNowhere;
  if (b.contains(0.0)) return kWholeLine;
  return a * Interval{down(1.0 / b.upper), up(1.0 / b.lower)};
}

Interval square(Interval a) {
  const double low = a.contains(0.0) ? 0.0 : std::min(std::abs(a.lower), std::abs(a.upper));
  const double high = std::max(std::abs(a.lower), std::abs(a.upper));
  if (std::isnan(a.lower)) return kNowhere;
  return {std::max(0.0, down(low * low)), up(high * high)};
}

Interval square_over(Interval a, Interval b) {
  if (std::isnan(a.lower) || std::isnan(b.lower)) return kNowhere;
  if (!(b.lower > 0.0)) return kWholeLine;
  const Interval top = square(a);
  return {std::max(0.0, down(top.lower / b.upper)), up(top.upper / b.lower)};
}

Interval sqrt(Interval a) {
  if (!(a.upper >= 0.0)) return kNowhere;
  return {std::max(0.0, down(std::sqrt(std::max(0.0, a.lower)))), up(std::sqrt(a.upper))};
}

Interval asin(Interval a) {
  if (!(a.upper >= -1.0) || !(a.lower <= 1.0)) return kNowhere;
  return {down_function(std::asin(std::max(-1.0, a.lower))),
          up_function(std::asin(std::min(1.0, a.upper)))};
}

Interval acos(Interval a) {
  if (!(a.upper >= -1.0) || !(a.lower <= 1.0)) return kNowhere;
  return {down_function(std::acos(std::min(1.0, a.upper))),
          up_function(std::acos(std::max(-1.0, a.lower)))};
}

Interval atan(Interval a) {
  return {down_function(std::atan(a.lower)), up_function(std::atan(a.upper))};
}

Interval abs(Interval a) {
  const double high = std::max(std::abs(a.lower), std::abs(a.upper));
  if (std::isnan(a.lower)) return kNowhere;
  return {a.contains(0.0) ? 0.0 : std::min(std::abs(a.lower), std::abs(a.upper)), high};
}

Interval min(Interval a, Interval b) {
  if (std::isnan(a.lower) || std::isnan(b.lower)) return kNowhere;
  return {std::min(a.lower, b.lower), std::min(a.upper, b.upper)};
}

Interval max(Interval a, Interval b) { return -min(-a, -b); }

Interval intersect(Interval a, Interval b) {
  if (std::isnan(a.lower) || std::isnan(b.lower)) return kNowhere;
  const Interval common{std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
  return common.lower <= common.upper ? common : kNowhere;
}

}  // namespace torquewright::optimization
