// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "gearbox/teeth/mesh.hpp"
#include "gearbox/train/kinematics.hpp"

namespace torquewright::gearbox {

/// Lambda of a path without profile shift, a mean of distances below 2: the limits cut off nothing,
/// but keep enclosures over wide ranges of teeth useful. docs/derivations/efficiency.md, "Limits".
template <class T>
T limited_loss_factor(const ContactPath<T>& path) {
  return max(min(sliding_loss_factor(path), 2.0), 0.0);
}

/// Share of the rolling power that a mesh loses per unit of friction coefficient, carrier held.
/// docs/derivations/efficiency.md eq. (4). Dimensionless.
template <class T>
T external_loss_per_friction(const T& teeth_1, const T& teeth_2) {
  return std::numbers::pi * (1.0 / teeth_1 + 1.0 / teeth_2) *
         limited_loss_factor<T>(external_path(teeth_1, teeth_2));
}

template <class T>
T internal_loss_per_friction(const T& planet, const T& ring) {
  return std::numbers::pi * (1.0 / planet - 1.0 / ring) *
         limited_loss_factor<T>(internal_path(planet, ring));
}

/// Basic efficiencies of the meshes S-P1, P1-F, P2-O, carrier held.
template <class T>
struct ThreeKMeshEfficiencies {
  T sun_planet_1;
  T planet_1_fixed_ring;
  T planet_2_output_ring;
};

/// Basic efficiencies of the meshes S-P, P-R, carrier held.
template <class T>
struct PlanetaryMeshEfficiencies {
  T sun_planet;
  T planet_ring;
};

template <class T>
ThreeKMeshEfficiencies<T> mesh_efficiencies(const ThreeKTeeth<T>& teeth, double friction) {
  return {1.0 - friction * external_loss_per_friction(teeth.sun, teeth.planet_1),
          1.0 - friction * internal_loss_per_friction(teeth.planet_1, teeth.fixed_ring),
          1.0 - friction * internal_loss_per_friction(teeth.planet_2, teeth.output_ring)};
}

template <class T>
PlanetaryMeshEfficiencies<T> mesh_efficiencies(const PlanetaryTeeth<T>& teeth, double friction) {
  return {1.0 - friction * external_loss_per_friction(teeth.sun, teeth.planet),
          1.0 - friction * internal_loss_per_friction(teeth.planet, teeth.ring)};
}

/// Output power over input power, sun driving, for I2 < 1. docs/derivations/efficiency.md eq. (13).
template <class T>
T three_k_forward_efficiency(const T& ratio_1, const T& ratio_2,
                             const ThreeKMeshEfficiencies<T>& mesh) {
  const T first = mesh.sun_planet_1 * mesh.planet_1_fixed_ring;
  const T second = mesh.planet_1_fixed_ring * mesh.planet_2_output_ring;
  return (1.0 + first * ratio_1) * (1.0 - ratio_2) / ((1.0 + ratio_1) * (1.0 - second * ratio_2));
}

/// Output power over input power, output ring driving, for I2 < 1. Not positive: self-locking.
/// docs/derivations/efficiency.md eq. (14).
template <class T>
T three_k_backward_efficiency(const T& ratio_1, const T& ratio_2,
                              const ThreeKMeshEfficiencies<T>& mesh) {
  const T first = mesh.sun_planet_1 * mesh.planet_1_fixed_ring;
  const T second = mesh.planet_1_fixed_ring * mesh.planet_2_output_ring;
  return mesh.sun_planet_1 * (1.0 + ratio_1) * (second - ratio_2) /
         (mesh.planet_2_output_ring * (first + ratio_1) * (1.0 - ratio_2));
}

/// Single stage, sun driving, ratio = R/S. docs/derivations/efficiency.md eq. (17).
template <class T>
T planetary_forward_efficiency(const T& ratio, const PlanetaryMeshEfficiencies<T>& mesh) {
  return (1.0 + mesh.sun_planet * mesh.planet_ring * ratio) / (1.0 + ratio);
}

/// Single stage, carrier driving. docs/derivations/efficiency.md eq. (18).
template <class T>
T planetary_backward_efficiency(const T& ratio, const PlanetaryMeshEfficiencies<T>& mesh) {
  const T both = mesh.sun_planet * mesh.planet_ring;
  return (1.0 + ratio) * both / (both + ratio);
}

}  // namespace torquewright::gearbox
