// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "gearbox/train/kinematics.hpp"

namespace torquewright::gearbox {

// Lossless, all planets sharing equally. Magnitudes of a train that drives: multiply a force by the
// load-sharing factor of the number of planets where one planet may carry more than its share.

/// Radii on which the central gears roll on their planets [m].
struct ThreeKRadii {
  double sun_m = 0.0;
  double fixed_ring_m = 0.0;
  double output_ring_m = 0.0;
};

/// Working radii at a centre distance, with or without profile shift: a S/(S + P1), a F/(F - P1),
/// a O/(O - P2).
ThreeKRadii working_radii(const ThreeKTeeth<double>& teeth, double centre_m);

/// Torques on the central gears and forces on one planet. The carrier bears no torque.
struct ThreeKLoads {
  double sun_torque_Nm = 0.0;
  double fixed_ring_torque_Nm = 0.0;
  double sun_force_N = 0.0;  ///< Tangential, on each planet, with the fixed ring's.
  double fixed_ring_force_N = 0.0;
  double output_ring_force_N = 0.0;  ///< Against the other two, in the other layer.

  /// The two layers pull a planet with this force in opposite directions; times the distance of the
  /// layers' mid-planes it is the moment that tilts the planet.
  double tilting_force_N() const { return output_ring_force_N; }
};

/// Loads for a torque that the output ring delivers. docs/derivations/kinematics.md eq.
/// (13)...(15).
ThreeKLoads three_k_loads(double output_torque_Nm, double reduction, std::int64_t planet_count,
                          const ThreeKRadii& radii);

/// Radii on which sun and ring of a single stage roll on their planets [m].
struct PlanetaryRadii {
  double sun_m = 0.0;
  double ring_m = 0.0;
};

/// Working radii at a centre distance, with or without profile shift: a S/(S + P), a R/(R - P).
PlanetaryRadii working_radii(const PlanetaryTeeth<double>& teeth, double centre_m);

/// Single stage: torques on the central gears and their forces on one planet. The two forces are
/// equal where R = S + 2 P; with profile shift the planet rolls on another circle in each mesh.
struct PlanetaryLoads {
  double sun_torque_Nm = 0.0;
  double ring_torque_Nm = 0.0;
  double sun_force_N = 0.0;
  double ring_force_N = 0.0;
};

/// Loads for a torque that the carrier delivers. docs/derivations/strength.md eq. (1).
PlanetaryLoads planetary_loads(double output_torque_Nm, double reduction, std::int64_t planet_count,
                               const PlanetaryRadii& radii);

}  // namespace torquewright::gearbox
