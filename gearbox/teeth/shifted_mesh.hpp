// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "gearbox/teeth/mesh.hpp"
#include "gearbox/teeth/profile_shift.hpp"

namespace torquewright::gearbox {

/// A pair of gears with their tip diameters, at its centre distance. Lengths in modules.
struct CutPair {
  ShiftedPair pair;
  double working_angle_rad = 0.0;
  double tip_diameter_1 = 0.0;
  double tip_diameter_2 = 0.0;
};

/// Returns the pressure angle at a diameter of a gear; nothing inside its base circle.
std::optional<double> pressure_angle_rad(double teeth, double diameter);

/// Returns the ends of the path of contact; nothing where a tip lies inside its base circle.
std::optional<ContactPath<double>> contact_path(const CutPair& cut);

// Interference of a planet in a ring; each margin must be >= 0, nothing means that a circle needed
// for it does not exist. SDP/SI D785 section 5.

/// Margin z1/z2 - 1 + tan(alpha_a2)/tan(alpha_w) of involute interference. Dimensionless.
std::optional<double> involute_interference_margin(const CutPair& cut);

/// Margin theta_1 z1/z2 + inv(alpha_w) - inv(alpha_a2) - theta_2 of trochoid interference, in rad.
std::optional<double> trochoid_interference_margin(const CutPair& cut);

/// Margin theta_1 + inv(alpha_a1) - inv(alpha_w) - z2/z1 (theta_2 + inv(alpha_a2) - inv(alpha_w))
/// of trimming, in rad. It matters only where the planet is pushed in radially; the trains here are
/// assembled along the axis.
std::optional<double> trimming_margin(const CutPair& cut);

}  // namespace torquewright::gearbox
