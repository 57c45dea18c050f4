// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/tooth_form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kAddendum = 1.0;

void require_drawable(std::int64_t teeth, double profile_shift) {
  if (teeth < kMinDrawnTeeth) throw std::invalid_argument("tooth form: fewer than 7 teeth");
  if (!std::isfinite(profile_shift)) throw std::invalid_argument("tooth form: shift not finite");
}

}  // namespace

double base_radius(const ToothForm& form) {
  return 0.5 * static_cast<double>(form.teeth) * std::cos(kPressureAngle_rad);
}

double base_half_angle_rad(const ToothForm& form) {
  const double thickness =
      0.5 * std::numbers::pi + 2.0 * form.profile_shift * std::tan(kPressureAngle_rad);
  return thickness / static_cast<double>(form.teeth) + involute(kPressureAngle_rad);
}

double half_angle_rad(const ToothForm& form, double radius) {
  const double ratio = std::min(1.0, base_radius(form) / radius);
  return base_half_angle_rad(form) - involute(std::acos(ratio));
}

ToothForm external_gear(std::int64_t teeth, double profile_shift, double hob_addendum) {
  require_drawable(teeth, profile_shift);
  const double pitch_radius = 0.5 * static_cast<double>(teeth);
  const ToothForm form{.teeth = teeth,
                       .internal = false,
                       .profile_shift = profile_shift,
                       .tip_radius = pitch_radius + kAddendum + profile_shift,
                       .root_radius = pitch_radius - hob_addendum + profile_shift,
                       .fillet_radius = kHobTipRadius};
  if (form.tip_radius <= base_radius(form) || half_angle_rad(form, form.tip_radius) <= 0.0) {
    throw std::invalid_argument("tooth form: no tooth tip with this profile shift");
  }
  return form;
}

ToothForm internal_gear(std::int64_t teeth, double profile_shift, double dedendum) {
  require_drawable(teeth, profile_shift);
  const double pitch_radius = 0.5 * static_cast<double>(teeth);
  const ToothForm form{.teeth = teeth,
                       .internal = true,
                       .profile_shift = profile_shift,
                       .tip_radius = pitch_radius - kAddendum + profile_shift,
                       .root_radius = pitch_radius + dedendum + profile_shift,
                       .fillet_radius = kRingFilletRadius};
  if (form.root_radius <= base_radius(form) || half_angle_rad(form, form.root_radius) <= 0.0) {
    throw std::invalid_argument("tooth form: no tooth space with this profile shift");
  }
  return form;
}

std::optional<double> largest_hob_tip_radius(const PlanetInRing& mesh) {
  const double cosine = std::cos(kPressureAngle_rad);
  const double sine = std::sin(kPressureAngle_rad);
  const double ring_base = 0.5 * mesh.ring_teeth * cosine;
  const double planet_base = 0.5 * mesh.teeth * cosine;
  if (mesh.ring_tip_radius <= ring_base || mesh.center_distance <= 0.0) return std::nullopt;
  const double working_cosine = (ring_base - planet_base) / mesh.center_distance;
  if (working_cosine <= 0.0 || working_cosine > 1.0) return std::nullopt;
  const double tangent_distance =
      mesh.center_distance * std::sqrt(1.0 - working_cosine * working_cosine);
  // From the planet's base tangent point to where the ring's tip touches it.
  const double lowest_contact =
      std::sqrt(mesh.ring_tip_radius * mesh.ring_tip_radius - ring_base * ring_base) -
      tangent_distance;
  if (lowest_contact <= 0.0) return std::nullopt;
  const double straight_depth =
      mesh.profile_shift + sine * (0.5 * mesh.teeth * sine - lowest_contact);
  return (mesh.hob_addendum - straight_depth) / (1.0 - sine);
}

ToothForm external_gear_in_ring(std::int64_t teeth, double profile_shift, const ToothForm& ring,
                                double center_distance, double hob_addendum) {
  ToothForm form = external_gear(teeth, profile_shift, hob_addendum);
  const auto largest = largest_hob_tip_radius({static_cast<double>(teeth), profile_shift,
                                               static_cast<double>(ring.teeth), ring.tip_radius,
                                               center_distance, hob_addendum});
  if (largest) form.fillet_radius = std::clamp(*largest, 0.0, kHobTipRadius);
  return form;
}

}  // namespace torquewright::gearbox
