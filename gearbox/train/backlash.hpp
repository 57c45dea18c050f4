// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/train/loads.hpp"

namespace torquewright::gearbox {

/// Angle of the output, sun and fixed ring held, per length of backlash in each mesh [rad/m].
/// With base radii the backlash is the one along the line of action, and the result holds for any
/// profile shift; with pitch radii it is the circumferential one of gears without shift.
struct ThreeKBacklash {
  double sun_planet_1 = 0.0;
  double planet_1_fixed_ring = 0.0;
  double planet_2_output_ring = 0.0;

  double total() const { return sun_planet_1 + planet_1_fixed_ring + planet_2_output_ring; }
};

/// Computes the backlash of a three-ring train from its ratios and radii [m].
/// docs/derivations/kinematics.md eq. (16).
ThreeKBacklash three_k_backlash(double ratio_1, double ratio_2, const ThreeKRadii& radii);

/// Single stage: each mesh gives the carrier this angle per length of backlash [rad/m]. Eq. (17).
double planetary_backlash(double sun_radius_m, double ring_radius_m);

}  // namespace torquewright::gearbox
