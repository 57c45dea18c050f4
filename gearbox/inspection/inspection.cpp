// SPDX-License-Identifier: Apache-2.0
#include "gearbox/inspection/inspection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/teeth/profile_shift.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/teeth/tooth_outline.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kPi = std::numbers::pi;

double count(const ToothForm& form) { return static_cast<double>(form.teeth); }

/// Half the angle of a tooth space at the base circle: outside it may be negative.
double half_space_at_base_rad(const ToothForm& form) {
  return form.internal ? base_half_angle_rad(form) : kPi / count(form) - base_half_angle_rad(form);
}

/// Profile angle at the circle of z + 2 x; nothing inside the base circle.
std::optional<double> middle_angle_rad(const ToothForm& form) {
  const double cosine = 2.0 * base_radius(form) / (count(form) + 2.0 * form.profile_shift);
  if (!(cosine > 0.0 && cosine < 1.0)) return std::nullopt;
  return std::acos(cosine);
}

double span(const ToothForm& form, std::int64_t teeth) {
  return kReferenceCosine *
             (kPi * (static_cast<double>(teeth) - 0.5) + count(form) * kReferenceInvolute) +
         2.0 * form.profile_shift * kReferenceSine;
}

/// Both jaws touch halfway along the span, on a tangent to the base circle.
bool touches_flanks(const ToothForm& form, double length) {
  const double radius = std::hypot(base_radius(form), 0.5 * length);
  for (const OutlineCurve& curve : half_pitch_curves(form)) {
    if (!curve.is_flank) continue;
    const Point top = curve.point(curve.from), bottom = curve.point(curve.to);
    return radius < std::hypot(top.x, top.y) && radius > std::hypot(bottom.x, bottom.y);
  }
  return false;
}

}  // namespace

std::optional<SpanMeasure> span_measure(const ToothForm& form) {
  const auto middle_rad = middle_angle_rad(form);
  if (form.internal || !middle_rad) return std::nullopt;
  const double wanted = 2.0 * base_radius(form) * std::tan(*middle_rad);
  const double teeth = (wanted - span(form, 0)) / (kPi * kReferenceCosine);
  const std::int64_t nearest = std::max<std::int64_t>(1, std::llround(teeth));
  for (const std::int64_t off : {0, 1, -1}) {
    const std::int64_t tried = nearest + off;
    if (tried < 1 || tried >= form.teeth || !touches_flanks(form, span(form, tried))) continue;
    return SpanMeasure{tried, span(form, tried)};
  }
  return std::nullopt;
}

std::optional<PinMeasure> best_pin(const ToothForm& form) {
  const auto middle_rad = middle_angle_rad(form);
  if (!middle_rad) return std::nullopt;
  const double half_rad = half_space_at_base_rad(form);
  const double sign = form.internal ? -1.0 : 1.0;
  // The pin's centre lies on the tangent to the base circle through the point that it touches:
  // tan(phi) - tan(alpha') = inv(phi) + half the space, outside.
  const double centre_rad = std::tan(*middle_rad) + sign * half_rad;
  if (!(centre_rad > 0.0 && centre_rad < 0.5 * kPi)) return std::nullopt;
  const double diameter = 2.0 * base_radius(form) * (sign * involute(centre_rad) + half_rad);
  const auto length = over_pins(form, diameter);
  if (!(diameter > 0.0) || !length) return std::nullopt;
  return PinMeasure{diameter, *length};
}

std::optional<double> over_pins(const ToothForm& form, double pin_diameter) {
  const double sign = form.internal ? -1.0 : 1.0;
  const double half_rad = half_space_at_base_rad(form);
  const auto centre_rad =
      inverse_involute_rad(sign * (pin_diameter / (2.0 * base_radius(form)) - half_rad));
  if (!centre_rad) return std::nullopt;
  const double centres = 2.0 * base_radius(form) / std::cos(*centre_rad);
  const double across =
      form.teeth % 2 == 0 ? centres : centres * std::cos(kPi / (2.0 * count(form)));
  return across + sign * pin_diameter;
}

}  // namespace torquewright::gearbox
