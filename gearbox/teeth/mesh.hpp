// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "gearbox/teeth/scalar_functions.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {

/// The path of contact from the pitch point to both ends, in base pitches. Dimensionless; an end
/// may be negative when profile shift moves the pitch point off the path.
template <class T>
struct ContactPath {
  T approach;  ///< epsilon_A, to the tip of gear 2 (the mate, the ring).
  T recess;    ///< epsilon_R, to the tip of gear 1 (the pinion, the planet in a ring).
};

template <class T>
T contact_ratio(const ContactPath<T>& path) {
  return path.approach + path.recess;
}

/// An end of a path without profile shift, from the difference of its tangents times teeth. It lies
/// in [0, 2) whatever the teeth (docs/derivations/efficiency.md, "Limits"); this cuts off nothing,
/// but keeps an enclosure over a wide range of teeth, where the difference is poor, finite.
template <class T>
T path_end(const T& tangents_times_teeth) {
  return max(min(tangents_times_teeth / (2.0 * std::numbers::pi), 2.0), 0.0);
}

/// Two external gears without profile shift. docs/derivations/efficiency.md eq. (1).
template <class T>
ContactPath<T> external_path(const T& teeth_1, const T& teeth_2) {
  return {path_end<T>(external_tip_tangent_times_teeth(teeth_2) - kReferenceTangent * teeth_2),
          path_end<T>(external_tip_tangent_times_teeth(teeth_1) - kReferenceTangent * teeth_1)};
}

/// A planet in a ring without profile shift. docs/derivations/efficiency.md eq. (2).
template <class T>
ContactPath<T> internal_path(const T& planet, const T& ring) {
  return {path_end<T>(kReferenceTangent * ring - ring_tip_tangent_times_teeth(ring)),
          path_end<T>(external_tip_tangent_times_teeth(planet) - kReferenceTangent * planet)};
}

/// Lambda, the mean of |path coordinate| over the pairs that share the load, for contact ratios in
/// [1, 3) and any sign of either end. docs/derivations/efficiency.md eq. (8). Dimensionless.
template <class T>
T sliding_loss_factor(const ContactPath<T>& path) {
  using std::abs;
  const auto signed_square = [](const T& x) -> T {
    using std::abs;
    return x * abs(x);
  };
  const T total = path.approach + path.recess;
  const T shared_by_two = min(total - 1.0, 1.0);
  const T shared_by_three = max(total - 2.0, 0.0);
  const auto end_zone = [&](const T& end) -> T {
    const T inner = signed_square(end - shared_by_three);
    return (signed_square(end) - inner) / 3.0 + (inner - signed_square(end - shared_by_two)) / 2.0;
  };
  const T middle = signed_square(1.0 - path.approach) + signed_square(1.0 - path.recess);
  return end_zone(path.approach) + end_zone(path.recess) + max(middle, 0.0) +
         max(-1.0 * middle, 0.0) / 3.0;
}

/// Involute interference of a planet in a ring without profile shift: must be >= 0. Dimensionless.
/// P/R - 1 + tan(alpha_a2)/tan(alpha): the ring's tip must not reach inside the planet's base
/// tangent.
template <class T>
T involute_interference_margin(const T& planet, const T& ring) {
  return (planet + ring_tip_tangent_times_teeth(ring) / kReferenceTangent) / ring - 1.0;
}

/// Trochoid interference of a planet in a ring without profile shift: must be >= 0 [rad].
/// theta_1 P/R + inv(alpha) - inv(alpha_a2) - theta_2, SDP/SI D785 eq. (5-6)...(5-8).
template <class T>
T trochoid_interference_margin(const T& planet, const T& ring) {
  using std::acos;
  const T planet_tip = planet / 2.0 + 1.0;
  const T ring_tip = ring / 2.0 - 1.0;
  const T centre = (ring - planet) / 2.0;
  const T involute_1 = involute_of_tangent<T>(external_tip_tangent_times_teeth(planet) / planet);
  const T involute_2 = involute_of_tangent<T>(ring_tip_tangent_times_teeth(ring) / ring);
  const T at_planet =
      acos((square(ring_tip) - square(planet_tip) - square(centre)) / (2.0 * centre * planet_tip)) +
      involute_1 - kReferenceInvolute;
  const T at_ring =
      acos((square(centre) + square(ring_tip) - square(planet_tip)) / (2.0 * centre * ring_tip));
  return at_planet * planet / ring + kReferenceInvolute - involute_2 - at_ring;
}

}  // namespace torquewright::gearbox
