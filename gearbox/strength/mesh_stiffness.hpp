// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "gearbox/strength/tooth_load.hpp"

namespace torquewright::gearbox {

/// c' of ISO 6336-1, method C, from memory: the greatest stiffness of one pair of steel teeth, per
/// millimetre of width, along the line of action. It holds for spur gears of the reference profile,
/// outside and in rings, with solid rims and from 100 N/mm of load; below that it is less.
inline constexpr double kSingleStiffness_N_mm_um = 14.0;
/// Of the steel that c' is of; another's goes with its modulus.
inline constexpr double kStiffnessYoung_MPa = 206000.0;

/// c_gamma = c' (0.75 eps_alpha + 0.25): the mean over the pairs in contact.
template <class T>
T mesh_stiffness_N_mm_um(const T& contact_ratio) {
  return kSingleStiffness_N_mm_um * (0.75 * contact_ratio + 0.25);
}

/// By layer: turn of the output for a torque there, sun and held ring still, times the layer's face
/// width. docs/derivations/strength.md eq. (16). Requires a train without objections.
std::vector<double> layer_softness_rad_mm_Nm(const StrengthCase& strength);

/// Of the teeth alone, at the output, with the case's face widths; bearings, carrier, shafts, rims
/// and what planets share unevenly are left out.
double torsional_stiffness_Nm_rad(const StrengthCase& strength);

}  // namespace torquewright::gearbox
