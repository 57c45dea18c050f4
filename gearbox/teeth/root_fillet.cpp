// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/root_fillet.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "gearbox/teeth/shaper.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

constexpr int kBisections = 60;  // Halves an interval of order 1 below round-off.

// A root of `function` between `inside`, where it is negative, and `outside`, where it is not.
template <typename Function>
double bisect(double inside, double outside, Function function) {
  for (int step = 0; step < kBisections; ++step) {
    const double middle = 0.5 * (inside + outside);
    (function(middle) < 0.0 ? inside : outside) = middle;
  }
  return inside;
}

// Undercut, eq. (6): the hob's arc ends beyond the base tangent point and cuts into the involute.
bool is_undercut(const HobTrochoid& trochoid) {
  const double sine = std::sin(kPressureAngle_rad);
  const double end_distance = trochoid.hob_tip_radius - trochoid.arc_center_height / sine;
  return end_distance > trochoid.pitch_radius * sine;
}

// The normal with which the trochoid crosses the involute of an undercut tooth.
double undercut_normal_rad(const ToothForm& form, const HobTrochoid& trochoid) {
  const double base = base_radius(form);
  const double base_normal_rad =
      bisect(kPressureAngle_rad, 0.5 * std::numbers::pi,
             [&](double normal_rad) { return base - trochoid_point(trochoid, normal_rad).radius; });
  return bisect(base_normal_rad, kPressureAngle_rad, [&](double normal_rad) {
    const PolarPoint point = trochoid_point(trochoid, normal_rad);
    return point.angle_rad - half_angle_rad(form, point.radius);
  });
}

}  // namespace

HobTrochoid hob_trochoid(const ToothForm& external) {
  const double pitch_radius = 0.5 * static_cast<double>(external.teeth);
  const double hob_depth = pitch_radius + external.profile_shift - external.root_radius;
  const double sine = std::sin(kPressureAngle_rad);
  const double cosine = std::cos(kPressureAngle_rad);
  HobTrochoid trochoid{
      .pitch_radius = pitch_radius,
      .half_pitch_rad = std::numbers::pi / static_cast<double>(external.teeth),
      .hob_tip_radius = external.fillet_radius,
      // Eq. (3): the arc touches the hob's flank and its tip line.
      .arc_center_offset = 0.25 * std::numbers::pi - hob_depth * sine / cosine -
                           external.fillet_radius * (1.0 - sine) / cosine,
      .arc_center_height = external.profile_shift - hob_depth + external.fillet_radius,
      .end_normal_rad = kPressureAngle_rad};
  if (is_undercut(trochoid)) trochoid.end_normal_rad = undercut_normal_rad(external, trochoid);
  return trochoid;
}

PolarPoint trochoid_point(const HobTrochoid& trochoid, double normal_rad) {
  // Eq. (4): the common normal of hob and gear passes through the pitch point.
  const double along = -trochoid.arc_center_height / std::tan(normal_rad);
  const double roll_rad = (along - trochoid.arc_center_offset) / trochoid.pitch_radius;
  // Eq. (5): the point on the arc, seen from the gear's axis and turned back by the roll.
  const double x = along + trochoid.hob_tip_radius * std::cos(normal_rad);
  const double y = trochoid.pitch_radius + trochoid.arc_center_height -
                   trochoid.hob_tip_radius * std::sin(normal_rad);
  return {std::hypot(x, y), trochoid.half_pitch_rad - (std::atan2(x, y) - roll_rad)};
}

RingFillet ring_fillet(const ToothForm& internal) {
  const double base = base_radius(internal);
  // Eq. (7): the parallel of an involute at distance r is the same involute turned by r / r_b.
  const auto center_angle_rad = [&](double radius) {
    return half_angle_rad(internal, internal.root_radius - radius) - radius / base;
  };
  double radius = internal.fillet_radius;
  if (center_angle_rad(radius) < 0.0) {
    radius = bisect(0.0, radius, [&](double trial) { return -center_angle_rad(trial); });
  }
  const double center_radius = internal.root_radius - radius;
  const double string =
      std::sqrt(std::max(0.0, center_radius * center_radius - base * base)) + radius;
  const double flank_radius = std::hypot(base, string);
  return {.radius = radius,
          .center = {center_radius, std::max(0.0, center_angle_rad(radius))},
          .flank_end = {flank_radius, half_angle_rad(internal, flank_radius)}};
}

std::optional<ShaperTrochoid> shaper_trochoid(const ToothForm& internal) {
  const auto teeth = static_cast<double>(internal.teeth);
  const auto cutter = static_cast<double>(internal.shaper_teeth);
  const auto shaper =
      shaper_at_depth({teeth, internal.profile_shift, internal.root_radius, cutter});
  if (!shaper) return std::nullopt;
  const double rounding = std::min(internal.fillet_radius, full_shaper_rounding(*shaper));
  const double center_radius = shaper->tip_radius - rounding;
  const double base = shaper->base_radius;
  if (center_radius <= base) return std::nullopt;
  // Eq. (14): what is left of half the tooth's angle where the rounding's centre lies.
  const double half_tooth_rad = 0.5 * std::numbers::pi / cutter + involute(kPressureAngle_rad) -
                                involute(std::acos(base / center_radius));
  // On the line of action the shaper sees the centre at its working angle less its profile angle.
  const double working_rad = std::atan2(shaper->tangent_distance, base_radius(internal) - base);
  return ShaperTrochoid{.teeth_ratio = cutter / teeth,
                        .center_distance = shaper->center_distance,
                        .pitch_point = base_radius(internal) / std::cos(working_rad),
                        .tip_radius = rounding,
                        .arc_center_radius = center_radius,
                        .arc_center_angle_rad = half_tooth_rad - rounding / base,
                        .end_turn_rad = std::acos(base / center_radius) - working_rad};
}

PolarPoint trochoid_point(const ShaperTrochoid& trochoid, double turn_rad) {
  // Eq. (15): the common normal passes through the pitch point.
  const double x = trochoid.center_distance + trochoid.arc_center_radius * std::cos(turn_rad);
  const double y = trochoid.arc_center_radius * std::sin(turn_rad);
  const double length = std::hypot(x - trochoid.pitch_point, y);
  const double reach = 1.0 + trochoid.tip_radius / length;
  const double cut_x = trochoid.pitch_point + reach * (x - trochoid.pitch_point);
  const double cut_y = reach * y;
  // Eq. (16): seen from the ring's axis and turned back by the ring's turn.
  const double ring_turn_rad = trochoid.teeth_ratio * (turn_rad - trochoid.arc_center_angle_rad);
  return {std::hypot(cut_x, cut_y), std::atan2(cut_y, cut_x) - ring_turn_rad};
}

double curvature_radius(const ShaperTrochoid& trochoid, double turn_rad) {
  using Complex = std::complex<double>;
  // Eq. (22): the path of the rounding's centre as the ring sees it, and the rounding around it.
  const double k = trochoid.teeth_ratio;
  const Complex arm = std::polar(trochoid.arc_center_radius, turn_rad);
  const Complex place = trochoid.center_distance + arm;
  const Complex first = Complex(0.0, 1.0) * (arm - k * place);
  const Complex second = (2.0 * k - 1.0) * arm - k * k * place;
  const double speed = std::abs(first);
  return speed * speed * speed / (std::conj(first) * second).imag() + trochoid.tip_radius;
}

}  // namespace torquewright::gearbox
