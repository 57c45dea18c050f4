// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/relaxation/concave_forms.hpp"

#include "gearbox/proof/gears/root_form.hpp"
#include "gearbox/proof/gears/tooth_path.hpp"

namespace torquewright::gearbox::proof {
namespace {

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

Linearization negative_square(const RealPoint& point, const Interval& weight,
                              const Interval& constant, const std::array<Interval, 3>& slope) {
  const Linearization base = affine(point, constant, slope);
  Linearization result{-weight * square(base.value), slope};
  for (Interval& each : result.gradient) each *= -2 * weight * base.value;
  return result;
}

Linearization teeth_form(const Interval& slope, const Interval& constant, int gear,
                         const RealPoint& point) {
  if (gear == 0) return affine(point, constant, {slope, 0, 0});
  return affine(point, constant, {0, slope, gear == 1 ? Interval(0) : -slope});
}

Linearization ring_form(const Interval& slope, const Interval& constant, int layer,
                        const RealPoint& point) {
  return affine(point, constant, {slope, 2 * slope, layer == 1 ? Interval(0) : -slope});
}

Linearization min_teeth_form(const Alternative& alternative, int gear, const RealPoint& point) {
  const auto& minima = alternative.problem->min_teeth;
  const auto minimum = minima.find(alternative.train->free_gears[static_cast<std::size_t>(gear)]);
  return teeth_form(1, minimum == minima.end() ? Interval(-1) : Interval(whole(-minimum->second)),
                    gear, point);
}

Linearization carrier_clearance_form(const Alternative& alternative, const RealPoint& point) {
  const Interval right_angle = pi() / 2;
  const Interval angle = pi() / Interval(static_cast<long>(alternative.planet_count)) -
                         Interval(alternative.problem->min_carrier_clearance_rad);
  const Interval k = sin(max(-right_angle, min(right_angle, angle)));
  return affine(point, 0, {k, k - 1, 0});
}

Linearization neighbour_clearance_form(const Alternative& alternative, int layer,
                                       const RealPoint& point) {
  const Rational limit =
      alternative.problem->min_neighbour_clearance_mm / alternative.module_mm + 2;
  Linearization result = teeth_form(-1, -Interval(limit), layer, point);
  result += affine(point, 0, {alternative.sine, alternative.sine, 0});
  return result;
}

Linearization undercut_form(const Problem& problem, int gear, const RealPoint& point) {
  return teeth_form(1, -2 * undercut_depth(problem) / square(sin(pressure_angle())), gear, point);
}

Linearization sun_under_layer_2_form(const Alternative& alternative, const RealPoint& point) {
  const Interval module(alternative.module_mm);
  return affine(point, -2 * module, {0, 0, module / 2});
}

Linearization ring_wall_form(const Alternative& alternative, int layer, const RealPoint& point) {
  const Rational room_mm =
      (alternative.ring_space_mm -
       2 * alternative.module_mm * alternative.problem->cutters.shaper_depth()) /
          2 -
      alternative.ring_wall_mm;
  return ring_form(-Interval(alternative.module_mm) / 2, Interval(room_mm), layer, point);
}

Linearization ring_tip_form(const Alternative& alternative, int layer, const RealPoint& point) {
  const Interval module(alternative.module_mm);
  return ring_form(module * (1 - cos(pressure_angle())) / 2, -module, layer, point);
}

Linearization shaper_feed_form(const Alternative& alternative, int layer, const RealPoint& point) {
  return ring_form(1, -number(alternative.least_fed_ring), layer, point);
}

std::optional<Linearization> ratio_max_form(const Alternative& alternative,
                                            const RealPoint& point) {
  const Rational& ratio = alternative.greatest_ratio;
  if (!alternative.train->is_stepped()) return planetary_ratio(ratio, point);
  if (ratio < 1) return std::nullopt;
  Linearization result = perspective(point, ratio);
  result.scale(Interval(Rational(-4 * (ratio - 1) / ratio)));
  result += affine(point, 0, {0, Interval(Rational(-2 / ratio)), 1});
  return result;
}

std::optional<Linearization> ratio_min_form(const Alternative& alternative, const Box& box,
                                            const RealPoint& point) {
  const Rational& ratio = alternative.least_ratio;
  if (!alternative.train->is_stepped()) {
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
  const Rational first_slope = 2 / ratio + curvature * (least + greatest - 2 * product);
  return affine(point, 0, {Interval(sun_slope), Interval(first_slope), -1});
}

Linearization paper_cost_form(const Alternative& alternative, const Interval& threshold,
                              const Box& box, const RealPoint& point) {
  const Rational bore_teeth = alternative.problem->rotor_inner_diameter_mm / alternative.module_mm;
  const Interval most_sun(whole(box.upper[0]));
  Linearization result = affine(point, threshold - Interval(1) / square(most_sun), {0, 0, 0});
  result += negative_square(point, 1, -Interval(bore_teeth), {1, 2, 0});
  result += negative_square(point, 1, 0, {0, 1, 0});
  result += negative_square(point, 1, 0, {0, 1, -1});
  result += negative_square(point, 1, 0, {1, 2, -1});
  return result;
}

}  // namespace torquewright::gearbox::proof
