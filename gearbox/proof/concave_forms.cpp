// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/concave_forms.hpp"

namespace torquewright::gearbox::proof {
namespace {

Rational whole(std::int64_t value) { return Rational(static_cast<long>(value)); }

/// -weight (slope . x + constant)^2
Linearization negative_square(const RealPoint& point, const Interval& weight,
                              const Interval& constant, const std::array<Interval, 3>& slope) {
  const Linearization base = affine(point, constant, slope);
  Linearization result{-weight * square(base.value), slope};
  for (Interval& each : result.gradient) each *= -2 * weight * base.value;
  return result;
}

/// P1^2 / (G S + 2 P1), jointly convex.
Linearization perspective(const RealPoint& point, const Rational& ratio) {
  const Rational cone = ratio * point[0] + 2 * point[1];
  const Rational slope = point[1] / cone;
  return {Interval(Rational(slope * point[1])),
          {Interval(Rational(-slope * slope * ratio)),
           Interval(Rational(2 * slope - 2 * slope * slope)), 0}};
}

Linearization planetary_ratio(const Rational& ratio, const RealPoint& point) {
  return affine(point, 0, {Interval(Rational(ratio - 2)), -2, 0});
}

}  // namespace

Linearization affine(const RealPoint& point, const Interval& constant,
                     const std::array<Interval, 3>& slope) {
  Linearization result{constant, slope};
  for (std::size_t i = 0; i < point.size(); ++i) result.value += slope[i] * Interval(point[i]);
  return result;
}

Linearization min_teeth_form(const Alternative& alternative, std::size_t gear,
                             const RealPoint& point) {
  const auto& minima = alternative.problem->min_teeth;
  const auto minimum = minima.find(variable_names(*alternative.problem)[gear]);
  std::array<Interval, 3> slope{0, 0, 0};
  slope[gear] = 1;
  return affine(point, minimum == minima.end() ? Interval(-1) : Interval(whole(-minimum->second)),
                slope);
}

Linearization carrier_clearance_form(const Alternative& alternative, const RealPoint& point) {
  const Interval right_angle = pi() / 2;
  const Interval angle = pi() / Interval(static_cast<long>(alternative.planet_count)) -
                         Interval(alternative.problem->min_carrier_clearance_rad);
  const Interval k = sin(max(-right_angle, min(right_angle, angle)));
  return affine(point, 0, {k, k - 1, 0});
}

Linearization neighbour_clearance_form(const Alternative& alternative, std::size_t layer,
                                       const RealPoint& point) {
  const Rational limit =
      alternative.problem->min_neighbour_clearance_mm / alternative.module_mm + 2;
  std::array<Interval, 3> slope{alternative.sine, alternative.sine, 0};
  slope[layer] -= 1;
  return affine(point, -Interval(limit), slope);
}

std::optional<Linearization> ratio_max_form(const Alternative& alternative,
                                            const RealPoint& point) {
  const Rational& ratio = alternative.greatest_ratio;
  if (alternative.planetary) return planetary_ratio(ratio, point);
  // A range that reaches zero admits P1 < P2, which this form would refute.
  if (ratio < 1 || alternative.least_ratio <= 0) return std::nullopt;
  Linearization result = perspective(point, ratio);
  result.scale(Interval(Rational(-4 * (ratio - 1) / ratio)));
  result += affine(point, 0, {0, Interval(Rational(1 - 2 / ratio)), -1});
  return result;
}

std::optional<Linearization> ratio_min_form(const Alternative& alternative, const Box& box,
                                            const RealPoint& point) {
  const Rational& ratio = alternative.least_ratio;
  if (alternative.planetary) {
    Linearization result = planetary_ratio(ratio, point);
    result.scale(-1);
    return result;
  }
  if (ratio < 1) return std::nullopt;
  const auto slope = [&ratio](std::int64_t sun, std::int64_t first) {
    return Rational(whole(first) / (ratio * whole(sun) + 2 * whole(first)));
  };
  const Rational least = slope(box.upper[0], box.lower[1]);
  const Rational greatest = slope(box.lower[0], box.upper[1]);
  const Rational curvature = 4 * (ratio - 1) / ratio;
  const Rational product = least * greatest;
  const Rational sun_slope = -curvature * product * ratio;
  const Rational first_slope = 2 / ratio + curvature * (least + greatest - 2 * product) - 1;
  return affine(point, 0, {Interval(sun_slope), Interval(first_slope), 1});
}

Linearization paper_cost_form(const Alternative& alternative, const Interval& threshold,
                              const Box& box, const RealPoint& point) {
  const Rational bore_teeth = alternative.problem->rotor_inner_diameter_mm / alternative.module_mm;
  const Interval most_sun(whole(box.upper[0]));
  Linearization result = affine(point, threshold - Interval(1) / square(most_sun), {0, 0, 0});
  result += negative_square(point, 1, -Interval(bore_teeth), {1, 2, 0});
  result += negative_square(point, 1, 0, {0, 1, 0});
  result += negative_square(point, 1, 0, {0, 0, 1});
  result += negative_square(point, 1, 0, {1, 1, 1});
  return result;
}

}  // namespace torquewright::gearbox::proof
