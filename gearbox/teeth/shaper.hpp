// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "gearbox/teeth/tooth_form.hpp"

namespace torquewright::gearbox {

/// A ring and what shapes it: a cutter without profile shift of its own, as long as gives the
/// ring's root. Lengths in modules.
struct ShapedRing {
  double teeth = 0.0;
  double profile_shift = 0.0;
  double root_radius = 0.0;
  double shaper_teeth = 0.0;
};

/// The shaper at its full depth in the ring. Lengths in modules.
struct ShaperAtDepth {
  double teeth = 0.0;
  double center_distance = 0.0;
  double tip_radius = 0.0;
  double base_radius = 0.0;
  double tangent_distance = 0.0;  ///< Distance between the base tangent points of ring and shaper.
};

/// Returns the shaper; nothing where one of so many teeth does not mesh with the ring or is pointed
/// at its tips.
std::optional<ShaperAtDepth> shaper_at_depth(const ShapedRing& ring);

/// Returns the largest rounding of a shaper's tips that leaves the ring's involute out to where the
/// planet's tip touches it (docs/derivations/tooth_outline.md eq. (12)). Negative: none does.
/// Nothing where planet and ring do not mesh.
std::optional<double> largest_shaper_tip_radius(const ShaperAtDepth& shaper,
                                                const PlanetInRing& mesh, double planet_tip_radius);

/// Returns the rounding that takes all of the land of a shaper's tip, eq. (13).
double full_shaper_rounding(const ShaperAtDepth& shaper);

}  // namespace torquewright::gearbox
