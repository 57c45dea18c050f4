// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "dynamics/jet.hpp"

namespace torquewright::optimization {

// Functions of published formulas that dynamics/ has no use for, of doubles and of jets.

template <typename Number>
Number square(const Number& x) {
  return x * x;
}
template <typename Number>
Number cube(const Number& x) {
  return x * x * x;
}
template <typename Number>
Number fourth(const Number& x) {
  return square(square(x));
}

inline double exponential(double x) { return std::exp(x); }
template <int kOrder>
dynamics::ForwardNumber<kOrder> exponential(const dynamics::ForwardNumber<kOrder>& x) {
  const double f = std::exp(x.value());
  return x.chained(f, f, f);
}

inline double logarithm(double x) { return std::log(x); }
template <int kOrder>
dynamics::ForwardNumber<kOrder> logarithm(const dynamics::ForwardNumber<kOrder>& x) {
  const double v = x.value();
  return x.chained(std::log(v), 1 / v, -1 / (v * v));
}

/// Of positive numbers.
inline double power(double x, double exponent) { return std::pow(x, exponent); }
template <int kOrder>
dynamics::ForwardNumber<kOrder> power(const dynamics::ForwardNumber<kOrder>& x, double exponent) {
  const double v = x.value(), f = std::pow(v, exponent);
  return x.chained(f, exponent * f / v, exponent * (exponent - 1) * f / (v * v));
}

}  // namespace torquewright::optimization
