// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace torquewright::actuator {

/// Searches on a line that every bound of a region is found by.

/// The last point from `inside` towards `outside` at which f >= 0, to `tolerance`, if f changes its
/// sign once between them: false position (Illinois), with a bisection whenever it slows down or f
/// is not finite. Requires f(inside) >= 0 > f(outside). The point returned has f >= 0.
template <typename Function>
double last_nonnegative(const Function& f, double inside, double outside, double tolerance) {
  double f_inside = f(inside);
  double f_outside = f(outside);
  double previous_width = std::abs(outside - inside);
  while (previous_width > tolerance) {
    double point = inside + (outside - inside) * f_inside / (f_inside - f_outside);
    // Aim half a tolerance past a straight line's root, so that the far end closes in as well.
    point += std::copysign(0.5 * tolerance, outside - inside);
    const double lowest = std::min(inside, outside);
    const double highest = std::max(inside, outside);
    if (!(point > lowest && point < highest)) point = 0.5 * (inside + outside);
    if (point == inside || point == outside) break;
    const double value = f(point);
    if (value >= 0.0) {
      inside = point;
      f_inside = value;
      f_outside *= 0.5;
    } else {
      outside = point;
      f_outside = value;
      f_inside *= 0.5;
    }
    const double width = std::abs(outside - inside);
    if (width > 0.5 * previous_width) {
      const double middle = 0.5 * (inside + outside);
      if (middle == inside || middle == outside) break;
      const double at_middle = f(middle);
      (at_middle >= 0.0 ? inside : outside) = middle;
      (at_middle >= 0.0 ? f_inside : f_outside) = at_middle;
    }
    previous_width = std::abs(outside - inside);
  }
  return inside;
}

/// Where f is greatest between two points, if it rises and then falls (golden section); the ends
/// count. To `tolerance`.
template <typename Function>
double greatest_point(const Function& f, double low, double high, double tolerance) {
  constexpr double kGolden = 0.61803398874989485;
  const double ends[2] = {low, high};
  double left = high - kGolden * (high - low);
  double right = low + kGolden * (high - low);
  double f_left = f(left);
  double f_right = f(right);
  while (high - low > tolerance) {
    if (f_left >= f_right) {
      high = std::exchange(right, left);
      f_right = f_left;
      left = high - kGolden * (high - low);
      f_left = f(left);
    } else {
      low = std::exchange(left, right);
      f_left = f_right;
      right = low + kGolden * (high - low);
      f_right = f(right);
    }
  }
  double best = f_left >= f_right ? left : right;
  for (const double end : ends) {
    if (f(end) >= std::max(f_left, f_right)) best = end;
  }
  return best;
}

}  // namespace torquewright::actuator
