// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/profile_shift.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {

namespace {

/// x1 + x2 (external) or x2 - x1 (internal).
double shift_between_centres(const ShiftedPair& pair) {
  return pair.kind == MeshKind::kExternal ? pair.shift_1 + pair.shift_2
                                          : pair.shift_2 - pair.shift_1;
}

}  // namespace

std::optional<double> inverse_involute_rad(double value) {
  if (!(value >= 0.0) || !std::isfinite(value)) return std::nullopt;
  // Newton on f(t) = t - atan(t) - value in the tangent t, f' = t^2/(1 + t^2). f is convex and the
  // start lies above the root, so the steps descend to it and never cross.
  double tangent = std::max(std::cbrt(3.0 * value), value) + std::min(value, std::numbers::pi / 2);
  for (int step = 0; step < 60 && tangent > 0.0; ++step) {
    const double excess = tangent - std::atan(tangent) - value;
    const double next = tangent - excess * (1.0 + tangent * tangent) / (tangent * tangent);
    if (!(next < tangent)) break;
    tangent = next;
  }
  return std::atan(tangent);
}

double teeth_between_centres(const ShiftedPair& pair) {
  return pair.kind == MeshKind::kExternal ? pair.teeth_1 + pair.teeth_2
                                          : pair.teeth_2 - pair.teeth_1;
}

std::optional<double> working_angle_rad(const ShiftedPair& pair) {
  // inv(alpha_w) = inv(alpha) + 2 tan(alpha) (x1 +- x2)/(z1 +- z2)
  return inverse_involute_rad(kReferenceInvolute + 2.0 * kReferenceTangent *
                                                       shift_between_centres(pair) /
                                                       teeth_between_centres(pair));
}

double centre_distance(const ShiftedPair& pair, double angle_rad) {
  return teeth_between_centres(pair) * kReferenceCosine / (2.0 * std::cos(angle_rad));
}

std::optional<double> working_angle_at_rad(double teeth, double centre) {
  const double cosine = teeth * kReferenceCosine / (2.0 * centre);
  if (!(cosine > 0.0 && cosine <= 1.0)) return std::nullopt;
  return std::acos(cosine);
}

double centre_increment(const ShiftedPair& pair, double centre) {
  return centre - teeth_between_centres(pair) / 2.0;
}

std::optional<double> closing_shift(const ShiftedPair& pair, double centre) {
  const double teeth = teeth_between_centres(pair);
  const std::optional<double> angle = working_angle_at_rad(teeth, centre);
  if (!angle) return std::nullopt;
  return teeth * (involute(*angle) - kReferenceInvolute) / (2.0 * kReferenceTangent);
}

double tip_diameter_keeping_clearance(double teeth, double mate_shift, double increment) {
  return teeth + 2.0 * (1.0 + increment - mate_shift);
}

double tip_diameter_external(double teeth, double shift) { return teeth + 2.0 * (1.0 + shift); }

double tip_diameter_planet_1(double teeth, double shift, double sun_shift, double increment) {
  return std::min(tip_diameter_keeping_clearance(teeth, sun_shift, increment),
                  tip_diameter_external(teeth, shift));
}

double tip_diameter_ring(double teeth, double shift) { return teeth - 2.0 * (1.0 - shift); }

}  // namespace torquewright::gearbox
