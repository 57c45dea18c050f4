// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "gearbox/teeth/scalar_functions.hpp"
#include "gearbox/train/kinematics.hpp"
#include "gearbox/train/mass.hpp"

namespace torquewright::gearbox {

/// Inertia of one pitch disc about its axis, m d^2/8 [kg m^2].
template <class T>
T disc_inertia_kg_m2(const Blank& blank, double face_width_m, const T& teeth) {
  return disc_mass_kg(blank, face_width_m, teeth) * square(blank.module_m * teeth) / 8.0;
}

/// Inertia of a ring from its pitch circle outwards, m (d_out^2 + d_in^2)/8 [kg m^2].
template <class T>
T ring_inertia_kg_m2(const Blank& blank, double face_width_m, const T& teeth) {
  const T pitch_m = blank.module_m * teeth;
  return ring_mass_kg(blank, face_width_m, teeth) *
         (square(pitch_m) + square(pitch_m + blank.ring_rim_m())) / 8.0;
}

/// Inertia of the sun's annulus [kg m^2].
template <class T>
T sun_inertia_kg_m2(const Blank& blank, const T& teeth) {
  const T pitch_m = blank.module_m * teeth;
  const T bore_m = max(pitch_m - blank.sun_rim_m(), 0.0);
  return sun_mass_kg(blank, teeth) * (square(pitch_m) + square(bore_m)) / 8.0;
}

/// Kinetic energy of one planet over half the square of the sun's speed [kg m^2]: its centre runs
/// with the carrier on the radius m (S + P)/2, its body spins.
template <class T>
T planet_inertia_at_sun_kg_m2(const Blank& blank, const T& mass_kg, const T& inertia_kg_m2,
                              const T& sun, const T& planet, const T& held_ring) {
  const T centre_m = blank.module_m * (sun + planet) / 2.0;
  return mass_kg * square(centre_m * carrier_speed_per_sun(sun, held_ring)) +
         inertia_kg_m2 * square(planet_speed_per_sun(sun, planet, held_ring));
}

/// Inertia of all that turns before the output ring, seen from the sun, carrier left out [kg m^2].
template <class T>
T three_k_input_inertia_kg_m2(const Blank& blank, double rotor_kg_m2, std::int64_t planet_count,
                              const ThreeKTeeth<T>& teeth) {
  const double width_1 = blank.face_width_1_m;
  const double width_2 = blank.face_width_2_m;
  const T mass =
      disc_mass_kg(blank, width_1, teeth.planet_1) + disc_mass_kg(blank, width_2, teeth.planet_2);
  const T inertia = disc_inertia_kg_m2(blank, width_1, teeth.planet_1) +
                    disc_inertia_kg_m2(blank, width_2, teeth.planet_2);
  const T planet = planet_inertia_at_sun_kg_m2(blank, mass, inertia, teeth.sun, teeth.planet_1,
                                               teeth.fixed_ring);
  return rotor_kg_m2 + sun_inertia_kg_m2(blank, teeth.sun) +
         static_cast<double>(planet_count) * planet;
}

/// Inertia of motor and gears seen from the sun, carrier left out [kg m^2].
/// docs/gearbox_constraints.md, "Objectives".
template <class T>
T three_k_inertia_at_sun_kg_m2(const Blank& blank, double rotor_kg_m2, std::int64_t planet_count,
                               const ThreeKTeeth<T>& teeth) {
  return three_k_input_inertia_kg_m2(blank, rotor_kg_m2, planet_count, teeth) +
         ring_inertia_kg_m2(blank, blank.face_width_2_m, teeth.output_ring) /
             square(three_k_reduction(teeth));
}

template <class T>
T planetary_inertia_at_sun_kg_m2(const Blank& blank, double rotor_kg_m2, std::int64_t planet_count,
                                 const PlanetaryTeeth<T>& teeth) {
  const double width = blank.face_width_1_m;
  const T planet = planet_inertia_at_sun_kg_m2<T>(blank, disc_mass_kg(blank, width, teeth.planet),
                                                  disc_inertia_kg_m2(blank, width, teeth.planet),
                                                  teeth.sun, teeth.planet, teeth.ring);
  return rotor_kg_m2 + sun_inertia_kg_m2(blank, teeth.sun) +
         static_cast<double>(planet_count) * planet;
}

/// The same seen from the output [kg m^2].
template <class T>
T reflected_inertia_kg_m2(const T& reduction, const T& inertia_at_sun_kg_m2) {
  return square(reduction) * inertia_at_sun_kg_m2;
}

}  // namespace torquewright::gearbox
