// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/shaper.hpp"

#include <cmath>
#include <numbers>

#include "gearbox/teeth/profile_shift.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

constexpr int kHalvings = 60;  // Of an interval of order 1, below round-off.

/// Half the angle that is left of the shaper's tooth between two roundings of this radius.
double land_rad(const ShaperAtDepth& shaper, double rounding) {
  const double center_radius = shaper.tip_radius - rounding;
  if (center_radius <= shaper.base_radius) return -1.0;
  const double half_tooth_rad = std::numbers::pi / (2.0 * shaper.teeth) + kReferenceInvolute -
                                involute(std::acos(shaper.base_radius / center_radius));
  return half_tooth_rad - rounding / shaper.base_radius;
}

}  // namespace

std::optional<ShaperAtDepth> shaper_at_depth(const ShapedRing& ring) {
  if (!(ring.shaper_teeth > 0.0) || ring.shaper_teeth >= ring.teeth) return std::nullopt;
  const ShiftedPair pair{MeshKind::kInternal, ring.shaper_teeth, ring.teeth, 0.0,
                         ring.profile_shift};
  const auto angle = working_angle_rad(pair);
  if (!angle) return std::nullopt;
  ShaperAtDepth shaper;
  shaper.teeth = ring.shaper_teeth;
  shaper.center_distance = centre_distance(pair, *angle);
  shaper.tip_radius = ring.root_radius - shaper.center_distance;
  shaper.base_radius = 0.5 * ring.shaper_teeth * kReferenceCosine;
  shaper.tangent_distance = shaper.center_distance * std::sin(*angle);
  if (land_rad(shaper, 0.0) < 0.0) return std::nullopt;
  return shaper;
}

std::optional<double> largest_shaper_tip_radius(const ShaperAtDepth& shaper,
                                                const PlanetInRing& mesh,
                                                double planet_tip_radius) {
  const double planet_base = 0.5 * mesh.teeth * kReferenceCosine;
  const double centres_on_base = 0.5 * (mesh.ring_teeth - mesh.teeth) * kReferenceCosine;
  if (centres_on_base <= 0.0 || mesh.center_distance < centres_on_base ||
      planet_tip_radius < planet_base) {
    return std::nullopt;
  }
  // Eq. (11): the string from the shaper's base circle to where the planet's tip touches the ring.
  const double string = std::sqrt(square(mesh.center_distance) - square(centres_on_base)) +
                        std::sqrt(square(planet_tip_radius) - square(planet_base)) -
                        shaper.tangent_distance;
  const double tip_string = std::sqrt(square(shaper.tip_radius) - square(shaper.base_radius));
  if (string > tip_string) return tip_string - string;  // Even an unrounded tip ends before it.
  return (tip_string - string) * (tip_string + string) / (2.0 * (shaper.tip_radius - string));
}

double full_shaper_rounding(const ShaperAtDepth& shaper) {
  if (land_rad(shaper, 0.0) <= 0.0) return 0.0;
  double inside = 0.0, outside = 1.0;
  for (int step = 0; step < kHalvings; ++step) {
    const double middle = 0.5 * (inside + outside);
    (land_rad(shaper, middle) > 0.0 ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace torquewright::gearbox
