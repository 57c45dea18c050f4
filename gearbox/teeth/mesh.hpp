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

/// The end of a path at an external gear's tip, without profile shift: the difference of tangents
/// in eq. (1) of docs/derivations/efficiency.md, written so that it grows with every term in which
/// the teeth stand ("Limits" there). An enclosure over a range of teeth is then exact.
template <class T>
T external_path_end(const T& teeth) {
  using std::sqrt;
  const T cosecant = 1.0 / reference_sine<T>();
  const T cotangent_squared = square(cosecant) - 1.0;
  const T y = reference_sine<T>() / 2.0 * teeth + cosecant;
  const T missing = cotangent_squared / (y + sqrt(square(y) - cotangent_squared));
  return (cosecant - missing) / (circle_constant<T>() * reference_cosine<T>());
}

/// The same at a ring's tip, which falls with the teeth. Where the tip circle lies inside the base
/// circle the involute ends at the base circle, and what is left grows with the teeth.
template <class T>
T ring_path_end(const T& teeth) {
  using std::sqrt;
  const T cosecant = 1.0 / reference_sine<T>();
  const T cotangent_squared = square(cosecant) - 1.0;
  const T cotangent = sqrt(cotangent_squared);
  const T y = reference_sine<T>() / 2.0 * teeth - cosecant;
  const T outside = cotangent + max(y - cotangent, 0.0);
  const T more =
      cotangent_squared / (outside + sqrt(max(square(outside) - cotangent_squared, 0.0)));
  const T cut_off = max(cotangent - y, 0.0);
  return (cosecant + more - cut_off) / (circle_constant<T>() * reference_cosine<T>());
}

/// Supremum of the contact ratio of external gears without profile shift.
inline constexpr double kSupremumOfExternalContactRatio =
    2.0 / (std::numbers::pi * kReferenceSine * kReferenceCosine);

/// Path of contact of two external gears without profile shift. docs/derivations/efficiency.md eq.
/// (1).
template <class T>
ContactPath<T> external_path(const T& teeth_1, const T& teeth_2) {
  return {external_path_end(teeth_2), external_path_end(teeth_1)};
}

/// Path of contact of a planet in a ring without profile shift. docs/derivations/efficiency.md eq.
/// (2).
template <class T>
ContactPath<T> internal_path(const T& planet, const T& ring) {
  return {ring_path_end(ring), external_path_end(planet)};
}

/// Lambda: the mean of |path coordinate| over the pairs that share the load, for contact ratios in
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
