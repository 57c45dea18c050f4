// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::gearbox {

/// Teeth of the 3K train: sun in, output ring out, fixed ring held, carrier free of torque.
template <class T>
struct ThreeKTeeth {
  T sun;
  T planet_1;  ///< In the layer of the sun and the fixed ring.
  T planet_2;  ///< In the layer of the output ring, on the same axle.
  T fixed_ring;
  T output_ring;
};

/// Teeth of the single stage: sun in, carrier out, ring held.
template <class T>
struct PlanetaryTeeth {
  T sun;
  T planet;
  T ring;
};

/// Coaxial rings without profile shift, seed 001 eq. (2), (3).
template <class T>
ThreeKTeeth<T> coaxial_three_k(const T& sun, const T& planet_1, const T& planet_2) {
  return {sun, planet_1, planet_2, sun + 2.0 * planet_1, sun + planet_1 + planet_2};
}

template <class T>
PlanetaryTeeth<T> coaxial_planetary(const T& sun, const T& planet) {
  return {sun, planet, sun + 2.0 * planet};
}

/// Basic ratio of the first stage, I1 = F/S, dimensionless.
template <class T>
T basic_ratio_1(const ThreeKTeeth<T>& teeth) {
  return teeth.fixed_ring / teeth.sun;
}

/// I2 = F P2/(P1 O), dimensionless. Below 1 the output turns with the sun, above 1 against it.
template <class T>
T basic_ratio_2(const ThreeKTeeth<T>& teeth) {
  return teeth.fixed_ring * teeth.planet_2 / (teeth.planet_1 * teeth.output_ring);
}

/// Sun speed over output ring speed, signed. docs/derivations/kinematics.md eq. (5).
/// Has a pole where P1 O = F P2: there the output ring stands still.
template <class T>
T three_k_reduction(const ThreeKTeeth<T>& teeth) {
  return (teeth.sun + teeth.fixed_ring) * teeth.planet_1 * teeth.output_ring /
         (teeth.sun * (teeth.planet_1 * teeth.output_ring - teeth.fixed_ring * teeth.planet_2));
}

/// Sun speed over carrier speed of the single stage. docs/derivations/kinematics.md eq. (7).
template <class T>
T planetary_reduction(const PlanetaryTeeth<T>& teeth) {
  return 1.0 + teeth.ring / teeth.sun;
}

/// Carrier speed over sun speed beside a held ring. docs/derivations/kinematics.md eq. (2).
template <class T>
T carrier_speed_per_sun(const T& sun, const T& held_ring) {
  return sun / (sun + held_ring);
}

/// Absolute planet speed over sun speed beside a held ring. docs/derivations/kinematics.md eq. (3).
template <class T>
T planet_speed_per_sun(const T& sun, const T& planet, const T& held_ring) {
  return (1.0 - held_ring / planet) * sun / (sun + held_ring);
}

}  // namespace torquewright::gearbox
