// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "gearbox/teeth/mesh.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {

// Where the involute ends at the root, and how far down the mate's tip needs it, without profile
// shift; lengths in modules. docs/derivations/tooth_outline.md eqs. (8)...(13). T as in mesh.hpp.

/// Converts a path of contact in base pitches to modules.
template <class T>
T path_in_modules(const T& base_pitches) {
  return circle_constant<T>() * reference_cosine<T>() * base_pitches;
}

/// Depth below its middle line to which a hob with this addendum and tip radius is straight.
template <class T>
T straight_depth_of_hob(const T& addendum, const T& tip_radius) {
  return addendum - (1.0 - reference_sine<T>()) * tip_radius;
}

/// Depth to which the hob has to be straight, so that the involute goes down to where the tip of a
/// ring of so many teeth touches it. Falls with the teeth, to 1.
template <class T>
T depth_reached_by_ring(const T& ring) {
  return reference_sine<T>() * path_in_modules<T>(ring_path_end(ring));
}

/// The same depth for an external mate. Grows with the teeth, to 1.
template <class T>
T depth_reached_by_gear(const T& teeth) {
  return reference_sine<T>() * path_in_modules<T>(external_path_end(teeth));
}

/// Distance beyond the pitch point, along the path of contact, to which a shaper with this many
/// teeth, addendum and tip radius leaves a ring's involute. With as many teeth as the planet, what
/// is left beyond the path that the planet reaches falls with the teeth.
template <class T>
T path_left_by_shaper(const T& shaper, const T& addendum, const T& tip_radius) {
  using std::sqrt;
  const T centre = shaper / 2.0 + addendum - tip_radius;  // Of the rounding, from the axis.
  const T base = reference_cosine<T>() * shaper / 2.0;
  return sqrt(square(centre) - square(base)) + tip_radius - reference_sine<T>() * shaper / 2.0;
}

/// Distance to which a planet's tip needs it. Grows with the planet's teeth.
template <class T>
T path_reached_by_planet(const T& planet) {
  return path_in_modules<T>(external_path_end(planet));
}

/// Number of teeth below which a hob that is straight to that depth undercuts.
template <class T>
T undercut_limit_teeth(const T& straight_depth) {
  return 2.0 * straight_depth / square(reference_sine<T>());
}

/// The largest tip radius of a hob that is straight as deep as is asked; negative: none.
inline double largest_hob_tip_radius_for(double addendum, double depth) {
  return (addendum - depth) / (1.0 - kReferenceSine);
}

}  // namespace torquewright::gearbox
