// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "gearbox/proof/gears/interval.hpp"

namespace torquewright::gearbox::proof {

/// A set of real numbers between two doubles: as sure as Interval, which it stands in for where
/// many boxes are asked, some hundred times as quick, and not as tight. Every operation of IEEE 754
/// used here (+ - * / and the root) is rounded to nearest; the ends then go outward by at least one
/// unit in the last place. What is outside an operation's domain is undefined (NaN), and stays so:
/// about it nothing is certain.
class RoughInterval {
 public:
  RoughInterval() = default;
  RoughInterval(int value) : low_(value), high_(value) {}  // NOLINT: numbers are intervals
  /// Requires |value| < 2^53, as all sums of teeth are.
  RoughInterval(long value)  // NOLINT
      : low_(static_cast<double>(value)), high_(static_cast<double>(value)) {}
  RoughInterval(const Rational& value)  // NOLINT: GMP rounds towards zero
      : low_(below(value.get_d())), high_(above(value.get_d())) {}
  RoughInterval(const Interval& value)  // NOLINT
      : low_(value.least_double()), high_(value.greatest_double()) {}
  /// Requires low <= high.
  RoughInterval(const Rational& low, const Rational& high)
      : low_(below(low.get_d())), high_(above(high.get_d())) {}

  bool is_defined() const { return low_ <= high_; }  // NaN compares with nothing.
  bool certainly_positive() const { return is_defined() && low_ > 0; }
  bool certainly_negative() const { return is_defined() && high_ < 0; }

  double least() const { return low_; }
  double greatest() const { return high_; }

  RoughInterval lower() const { return {low_, low_}; }
  RoughInterval upper() const { return {high_, high_}; }

  RoughInterval operator-() const { return {-high_, -low_}; }

  friend RoughInterval operator+(const RoughInterval& a, const RoughInterval& b) {
    return outward(a.low_ + b.low_, a.high_ + b.high_);
  }
  friend RoughInterval operator-(const RoughInterval& a, const RoughInterval& b) {
    return outward(a.low_ - b.high_, a.high_ - b.low_);
  }
  friend RoughInterval operator*(const RoughInterval& a, const RoughInterval& b) {
    return outward_hull(a.low_ * b.low_, a.low_ * b.high_, a.high_ * b.low_, a.high_ * b.high_);
  }
  friend RoughInterval operator/(const RoughInterval& a, const RoughInterval& b) {
    if (!(b.low_ > 0) && !(b.high_ < 0)) return undefined();
    return outward_hull(a.low_ / b.low_, a.low_ / b.high_, a.high_ / b.low_, a.high_ / b.high_);
  }

  friend RoughInterval sqrt(const RoughInterval& x) {
    return outward(std::sqrt(x.low_), std::sqrt(x.high_));
  }
  friend RoughInterval abs(const RoughInterval& x) {
    if (!x.is_defined() || x.low_ >= 0) return x;
    if (x.high_ <= 0) return -x;
    return {0.0, std::max(-x.low_, x.high_)};
  }
  friend RoughInterval square(const RoughInterval& x) {
    const RoughInterval size = abs(x);
    const RoughInterval result = size * size;
    return result.low_ < 0 ? RoughInterval(0.0, result.high_) : result;
  }
  friend RoughInterval max(const RoughInterval& a, const RoughInterval& b) {
    if (!a.is_defined() || !b.is_defined()) return undefined();
    return {std::max(a.low_, b.low_), std::max(a.high_, b.high_)};
  }
  friend RoughInterval min(const RoughInterval& a, const RoughInterval& b) { return -max(-a, -b); }
  friend RoughInterval hull(const RoughInterval& a, const RoughInterval& b) {
    if (!a.is_defined() || !b.is_defined()) return undefined();
    return {std::min(a.low_, b.low_), std::max(a.high_, b.high_)};
  }
  /// What both hold; `a` where they hold nothing in common.
  friend RoughInterval intersection(const RoughInterval& a, const RoughInterval& b) {
    if (!a.is_defined() || !b.is_defined()) return a;
    const RoughInterval both{std::max(a.low_, b.low_), std::min(a.high_, b.high_)};
    return both.is_defined() ? both : a;
  }

 private:
  RoughInterval(double low, double high) : low_(low), high_(high) {}

  static RoughInterval undefined() {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    return {kNaN, kNaN};
  }

  /// At least one unit in the last place away; the least double there is moves zero too.
  static double step(double x) {
    return std::abs(x) * std::numeric_limits<double>::epsilon() +
           std::numeric_limits<double>::denorm_min();
  }
  static double below(double x) { return x - step(x); }
  static double above(double x) { return x + step(x); }

  static RoughInterval outward(double low, double high) { return {below(low), above(high)}; }
  static RoughInterval outward_hull(double a, double b, double c, double d) {
    if (std::isnan(a) || std::isnan(b) || std::isnan(c) || std::isnan(d)) return undefined();
    return outward(std::min(std::min(a, b), std::min(c, d)),
                   std::max(std::max(a, b), std::max(c, d)));
  }

  double low_ = 0.0;
  double high_ = 0.0;
};

}  // namespace torquewright::gearbox::proof
