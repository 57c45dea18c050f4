// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/shaper_feed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

/// Fewest teeth of a ring without profile shift whose tips lie outside its base circle.
constexpr std::int64_t kFewestWithTips = 34;

/// Half the angle of a tooth without profile shift on its base circle, eq. (2).
double base_half_angle(double teeth, double profile_shift) {
  return (std::numbers::pi / 2.0 + 2.0 * profile_shift * kReferenceTangent) / teeth +
         kReferenceInvolute;
}

/// Eq. (18): the height above the line of centres, seen from the shaper's axis, at which the centre
/// of its rounding comes closest to the ring's tip.
std::optional<double> closest_height(double centre_radius, double rounding, double ring_tip,
                                     double teeth_ratio) {
  const double k = square(teeth_ratio);
  const double discriminant =
      square(k * rounding) +
      (1.0 - k) * (square(centre_radius) + k * square(rounding) - k * square(ring_tip));
  if (discriminant < 0.0) return std::nullopt;
  const double height = (k * rounding + std::sqrt(discriminant)) / (1.0 - k);
  if (height > centre_radius || height + rounding > ring_tip) return std::nullopt;
  return height;
}

}  // namespace

std::optional<double> feed_margin_rad(const FedShaper& shaper, const FedRing& ring) {
  const double ring_base = 0.5 * ring.teeth * kReferenceCosine;
  const double base = 0.5 * shaper.teeth * kReferenceCosine;
  const double centre = shaper.tip_radius - shaper.rounding;
  if (ring.teeth <= shaper.teeth || ring.tip_radius <= ring_base || centre <= base ||
      shaper.tip_radius > ring.tip_radius) {
    return std::nullopt;
  }
  const double teeth_ratio = shaper.teeth / ring.teeth;
  const auto height = closest_height(centre, shaper.rounding, ring.tip_radius, teeth_ratio);
  if (!height) return std::nullopt;
  // Eqs. (14) and (1): where the rounding's centre and the ring's tip stand at no turn.
  const double centre_rad = base_half_angle(shaper.teeth, 0.0) -
                            involute(std::acos(base / centre)) - shaper.rounding / base;
  const double tip_rad = base_half_angle(ring.teeth, ring.profile_shift) -
                         involute(std::acos(ring_base / ring.tip_radius));
  const double shaper_turn_rad = std::asin(*height / centre) - centre_rad;
  return teeth_ratio * shaper_turn_rad + tip_rad -
         std::asin((*height + shaper.rounding) / ring.tip_radius);
}

std::int64_t least_fed_ring(std::int64_t shaper_teeth, double addendum, double rounding) {
  const auto q = static_cast<double>(shaper_teeth);
  const FedShaper shaper{q, q / 2.0 + addendum, rounding};
  std::int64_t ring = std::max(shaper_teeth + 1, kFewestWithTips);
  // A ring of twice the shaper's teeth and more is far beyond the limit, some 20 teeth above them.
  for (const std::int64_t most = 2 * shaper_teeth + 100; ring < most; ++ring) {
    const auto z = static_cast<double>(ring);
    const auto margin = feed_margin_rad(shaper, {z, 0.0, z / 2.0 - 1.0});
    if (margin && *margin >= 0.0) break;
  }
  return ring;
}

}  // namespace torquewright::gearbox
