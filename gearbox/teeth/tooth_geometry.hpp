// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "gearbox/teeth/scalar_functions.hpp"

namespace torquewright::gearbox {

// The reference profile: 20 degrees, addendum 1 module, no profile shift.
inline constexpr double kReferenceAngle_rad = std::numbers::pi / 9.0;
inline constexpr double kReferenceSine = 0.34202014332566873304;
inline constexpr double kReferenceCosine = 0.93969262078590838405;
inline constexpr double kReferenceTangent = 0.36397023426620236135;
inline constexpr double kReferenceInvolute = kReferenceTangent - kReferenceAngle_rad;

/// The same and pi as numbers of a scalar T: a double and what it lacks, so that where T has more
/// digits than a double the search and its checker, which has them all, agree on the last digit.
template <class T>
T reference_sine() {
  return T(kReferenceSine) + 2.0136016534644645e-17;
}
template <class T>
T reference_cosine() {
  return T(kReferenceCosine) - 4.3850932840020416e-17;
}
template <class T>
T circle_constant() {
  return T(std::numbers::pi) + 1.2246467991473532e-16;
}

/// Teeth below which a rack undercuts: 2/sin^2 alpha = 17.097.
inline constexpr double kUndercutLimit_teeth = 2.0 / (kReferenceSine * kReferenceSine);

/// The involute function.
inline double involute(double angle_rad) { return std::tan(angle_rad) - angle_rad; }

/// The same, given the tangent.
template <class T>
T involute_of_tangent(const T& tangent) {
  using std::atan;
  return tangent - atan(tangent);
}

/// z tan(alpha_a) of an external gear: from cos(alpha_a) = z cos(alpha)/(z + 2), written so that z
/// stands in growing terms only.
template <class T>
T external_tip_tangent_times_teeth(const T& teeth) {
  using std::sqrt;
  return sqrt(square(kReferenceSine * teeth) + 4.0 * teeth + 4.0) / kReferenceCosine;
}

/// z tan(alpha_a) of a ring: from cos(alpha_a) = z cos(alpha)/(z - 2). Where the tip circle lies
/// inside the base circle there is no such angle; the involute then ends at the base circle, 0.
template <class T>
T ring_tip_tangent_times_teeth(const T& teeth) {
  using std::sqrt;
  const double completing = 2.0 / kReferenceSine;  // (z s)^2 - 4 z + 4 as a square plus a constant
  return sqrt(max(square(kReferenceSine * teeth - completing) + 4.0 - square(completing), 0.0)) /
         kReferenceCosine;
}

/// Distance of the ring's tip circle from its base circle in modules; must be positive.
template <class T>
T ring_tip_margin(const T& teeth) {
  return ((1.0 - kReferenceCosine) * teeth - 2.0) / 2.0;
}

}  // namespace torquewright::gearbox
