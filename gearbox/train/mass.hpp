// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numbers>

#include "gearbox/teeth/scalar_functions.hpp"
#include "gearbox/train/kinematics.hpp"

namespace torquewright::gearbox {

/// Material and widths that turn teeth into kilograms: one material, face widths by layer, one wall
/// for all rims.
struct Blank {
  double module_m = 0.0;
  double density_kg_m3 = 0.0;
  double face_width_1_m = 0.0;  ///< Layer of the sun.
  double face_width_2_m = 0.0;  ///< Layer of the output ring; 0 in a single stage.
  double wall_m = 0.0;          ///< Behind the root.

  double hob_depth = 1.25;     ///< Depth of the sun's root below its pitch circle, in modules.
  double shaper_depth = 1.25;  ///< Depth of the rings' roots, likewise.

  /// Diameter of a rim's far side beyond its pitch circle: root circle plus two walls.
  double ring_rim_m() const { return 2.0 * shaper_depth * module_m + 2.0 * wall_m; }
  double sun_rim_m() const { return 2.0 * hob_depth * module_m + 2.0 * wall_m; }
  double area_density(double face_width_m) const {
    return density_kg_m3 * std::numbers::pi / 4.0 * face_width_m;
  }
};

/// Mass of one pitch disc [kg].
template <class T>
T disc_mass_kg(const Blank& blank, double face_width_m, const T& teeth) {
  return blank.area_density(face_width_m) * square(blank.module_m * teeth);
}

/// Mass of a ring from its pitch circle outwards [kg].
template <class T>
T ring_mass_kg(const Blank& blank, double face_width_m, const T& teeth) {
  // (m z + k)^2 - (m z)^2 = k (2 m z + k)
  return blank.area_density(face_width_m) * blank.ring_rim_m() *
         (2.0 * blank.module_m * teeth + blank.ring_rim_m());
}

/// Mass of the sun: an annulus with a rim like a ring's, or a disc where the bore would vanish
/// [kg].
template <class T>
T sun_mass_kg(const Blank& blank, const T& teeth) {
  const T bore_m = max(blank.module_m * teeth - blank.sun_rim_m(), 0.0);
  return blank.area_density(blank.face_width_1_m) *
         (square(blank.module_m * teeth) - square(bore_m));
}

/// Gears of the 3K train without carrier [kg]. docs/gearbox_constraints.md, "Objectives".
template <class T>
T three_k_mass_kg(const Blank& blank, std::int64_t planet_count, const ThreeKTeeth<T>& teeth) {
  const double planets = static_cast<double>(planet_count);
  return planets * (disc_mass_kg(blank, blank.face_width_1_m, teeth.planet_1) +
                    disc_mass_kg(blank, blank.face_width_2_m, teeth.planet_2)) +
         ring_mass_kg(blank, blank.face_width_1_m, teeth.fixed_ring) +
         ring_mass_kg(blank, blank.face_width_2_m, teeth.output_ring) +
         sun_mass_kg(blank, teeth.sun);
}

template <class T>
T planetary_mass_kg(const Blank& blank, std::int64_t planet_count, const PlanetaryTeeth<T>& teeth) {
  return static_cast<double>(planet_count) *
             disc_mass_kg(blank, blank.face_width_1_m, teeth.planet) +
         ring_mass_kg(blank, blank.face_width_1_m, teeth.ring) + sun_mass_kg(blank, teeth.sun);
}

}  // namespace torquewright::gearbox
