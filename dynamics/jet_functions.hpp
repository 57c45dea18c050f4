// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "dynamics/jet.hpp"

namespace torquewright::dynamics {

// The functions that closed forms are made of, found by argument: write `using std::sin;` and call
// sin(x). Where a derivative is infinite (sqrt and hypot at 0, acos at 1) so are the slopes: who
// calls keeps away, as the double version does from what it divides by.

template <int kOrder>
ForwardNumber<kOrder> sqrt(const ForwardNumber<kOrder>& x) {
  const double f = std::sqrt(x.value());
  return x.chained(f, 0.5 / f, -0.25 / (f * x.value()));
}

template <int kOrder>
ForwardNumber<kOrder> sin(const ForwardNumber<kOrder>& x) {
  const double f = std::sin(x.value());
  return x.chained(f, std::cos(x.value()), -f);
}

template <int kOrder>
ForwardNumber<kOrder> cos(const ForwardNumber<kOrder>& x) {
  const double f = std::cos(x.value());
  return x.chained(f, -std::sin(x.value()), -f);
}

template <int kOrder>
ForwardNumber<kOrder> acos(const ForwardNumber<kOrder>& x) {
  const double v = x.value();
  const double f1 = -1 / std::sqrt((1 - v) * (1 + v));
  return x.chained(std::acos(v), f1, v * f1 * f1 * f1);
}

template <int kOrder>
ForwardNumber<kOrder> tanh(const ForwardNumber<kOrder>& x) {
  const double f = std::tanh(x.value());
  const double f1 = (1 - f) * (1 + f);
  return x.chained(f, f1, -2 * f * f1);
}

/// Magnitude; its slope at zero is 1.
template <int kOrder>
ForwardNumber<kOrder> abs(const ForwardNumber<kOrder>& x) {
  return x < 0 ? -x : x;
}

/// x less the nearest multiple of y; the multiple has no derivative.
template <int kOrder>
ForwardNumber<kOrder> remainder(ForwardNumber<kOrder> x, double y) {
  return x.set_value(std::remainder(x.value(), y));
}

template <int kOrder>
ForwardNumber<kOrder> hypot(const ForwardNumber<kOrder>& x, const ForwardNumber<kOrder>& y) {
  const double f = std::hypot(x.value(), y.value());
  return sqrt(x * x + y * y).set_value(f);
}

/// Angle of the direction (x, y), computed as its value plus the angle from there, whose tangent is
/// zero.
template <int kOrder>
ForwardNumber<kOrder> atan2(const ForwardNumber<kOrder>& y, const ForwardNumber<kOrder>& x) {
  const double length = std::hypot(x.value(), y.value());
  const double c = x.value() / length, s = y.value() / length;
  const ForwardNumber<kOrder> tangent = (y * c - x * s) / (x * c + y * s);
  // Second derivative of arctan at zero: 0.
  return tangent.chained(std::atan2(y.value(), x.value()), 1, 0);
}

template <int kOrder>
bool isfinite(const ForwardNumber<kOrder>& x) {
  bool is_finite = std::isfinite(x.value());
  for (int i = 0; i < x.count(); ++i) is_finite = is_finite && std::isfinite(x.slope(i));
  if constexpr (kOrder == 2) {
    for (int i = 0; i < x.count(); ++i) {
      for (int j = 0; j <= i; ++j) is_finite = is_finite && std::isfinite(x.curvature(i, j));
    }
  }
  return is_finite;
}

}  // namespace torquewright::dynamics
