// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace torquewright::actuator {

/// Searches on a line that every bound of a region is found by.

/// The last point from `inside` towards `outside` at which f >= 0, to `tolerance`, if f changes its
/// sign once between them: inverse quadratic interpolation where three points lie well for it, else
/// bisection (Chandrupatla). Requires f(inside) >= 0 > f(outside), which may be minus infinity. The
/// point returned has f >= 0.
template <typename Function>
double last_nonnegative(const Function& f, double inside, double outside, double tolerance) {
  double a = outside;  // the newest point; b is on the other side of the root, c the one before
  double b = inside;
  double c = outside;
  double f_a = f(a);
  double f_b = f(b);
  double f_c = f_a;
  double share = 0.5;  // of the way from a to b
  while (std::abs(b - a) > tolerance) {
    const double point = a + share * (b - a);
    if (point == a || point == b) break;
    const double value = f(point);
    const bool is_on_side_of_a = (value >= 0.0) == (f_a >= 0.0);
    c = is_on_side_of_a ? a : std::exchange(b, a);
    f_c = is_on_side_of_a ? f_a : std::exchange(f_b, f_a);
    a = point;
    f_a = value;
    const double xi = (a - b) / (c - b);
    const double phi = (f_a - f_b) / (f_c - f_b);
    const bool is_well_placed = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
    share = is_well_placed ? f_a / (f_b - f_a) * f_c / (f_b - f_c) +
                                 (c - a) / (b - a) * f_a / (f_c - f_a) * f_b / (f_c - f_b)
                           : 0.5;
    // At least half the tolerance from either end, so that the far end closes in as well.
    const double least_share = std::min(0.5, 0.5 * tolerance / std::abs(b - a));
    share = std::isfinite(share) ? std::clamp(share, least_share, 1.0 - least_share) : 0.5;
  }
  return f_a >= 0.0 ? a : b;
}

/// Where f is greatest between two points, if it rises and then falls; the ends count. Golden
/// section with steps to the vertex of a parabola where that is safe (Brent). To `tolerance`, but
/// no closer than doubles tell the top of a parabola from its neighbours.
template <typename Function>
double greatest_point(const Function& f, double low, double high, double tolerance) {
  constexpr double kGolden = 0.38196601125010515;
  constexpr double kFlat = 1.5e-8;  // square root of the rounding
  const double ends[2] = {low, high};
  tolerance = std::max(tolerance, kFlat * (high - low));
  double best = low + kGolden * (high - low);
  double second = best;
  double third = best;
  double f_best = f(best);
  double f_second = f_best;
  double f_third = f_best;
  double step = 0.0;
  double step_before = 0.0;
  while (std::max(high - best, best - low) > 2.0 * tolerance) {
    const double r = (best - second) * (f_best - f_third);
    const double q = (best - third) * (f_best - f_second);
    const double parabola = -0.5 * ((best - third) * q - (best - second) * r) / (q - r);
    const double limit = 0.5 * std::abs(std::exchange(step_before, step));
    const double target = best + parabola;
    if (std::abs(parabola) < limit && target > low + tolerance && target < high - tolerance) {
      step = parabola;
    } else {
      step_before = (best < 0.5 * (low + high) ? high : low) - best;
      step = kGolden * step_before;
    }
    const double point =
        best + (std::abs(step) >= tolerance ? step : std::copysign(tolerance, step));
    const double value = f(point);
    if (value >= f_best) {
      (point >= best ? low : high) = best;
      third = std::exchange(second, std::exchange(best, point));
      f_third = std::exchange(f_second, std::exchange(f_best, value));
      continue;
    }
    (point < best ? low : high) = point;
    if (value >= f_second || second == best) {
      third = std::exchange(second, point);
      f_third = std::exchange(f_second, value);
    } else if (value >= f_third || third == best || third == second) {
      third = point;
      f_third = value;
    }
  }
  for (const double end : ends) {
    if (f(end) >= f_best) return end;
  }
  return best;
}

}  // namespace torquewright::actuator
