// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/relaxation/linearization.hpp"

namespace torquewright::gearbox::proof {

Linearization& Linearization::operator+=(const Linearization& other) {
  value += other.value;
  for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] += other.gradient[i];
  return *this;
}

void Linearization::scale(const Interval& factor) {
  value *= factor;
  for (Interval& slope : gradient) slope *= factor;
}

bool is_negative_on(const Linearization& function, const RealPoint& point, const Box& box) {
  Interval greatest = function.value;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Interval to_lower = Rational(Rational(static_cast<long>(box.lower[i])) - point[i]);
    const Interval to_upper = Rational(Rational(static_cast<long>(box.upper[i])) - point[i]);
    greatest += max(function.gradient[i] * to_lower, function.gradient[i] * to_upper);
  }
  return greatest.certainly_negative();
}

}  // namespace torquewright::gearbox::proof
