// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/train/kinematics.hpp"

namespace torquewright::gearbox {

// How planets stand around the sun: carrier_clearance, equal_spacing, identical_planets,
// neighbour_clearance of docs/gearbox_constraints.md.

/// Planet gears around a sun, in one layer.
struct PlanetCircle {
  std::int64_t sun = 0;
  /// Teeth of the planet in the sun's layer: with the sun it sets the centre distance.
  std::int64_t planet = 0;
  std::int64_t planet_count = 0;
  Rational module_mm;
};

/// Judges pi/n - asin(P/(S + P)) >= alpha_min.
ConstraintReport carrier_clearance(const PlanetCircle& circle, const Rational& minimum_rad);

/// Judges whether n divides S + R, R the ring in the sun's layer.
ConstraintReport equal_spacing(std::int64_t sun, std::int64_t ring, std::int64_t planet_count,
                               std::string_view ring_name = "held ring");

/// Judges whether all stepped planets are alike.
ConstraintReport identical_planets(const ThreeKTeeth<std::int64_t>& teeth,
                                   std::int64_t planet_count);

/// Judges 2 a sin(pi/n) - m (P + 2) > limit for the planet gears of one layer.
ConstraintReport neighbour_clearance(const PlanetCircle& circle, std::string_view layer,
                                     std::int64_t planet_in_layer, const Rational& minimum_mm);

}  // namespace torquewright::gearbox
