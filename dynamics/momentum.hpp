// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// Momentum and inertia of the whole tree about its centre of mass, in the world's axes. A fixed
/// base counts with its own mass, as any body. Rotors count by rotor_spin_kg_m2: reflected inertia
/// alone has energy but no momentum.
struct Centroid {
  double mass_kg = 0;
  /// Centre of mass, from the world's origin.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();
  /// Angular momentum about the centre of mass (CAM).
  Eigen::Vector3d angular_momentum_Nm_s = Eigen::Vector3d::Zero();
  /// Inertia of all bodies as if they were one.
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();
  /// Angular velocity with which that one body would have this angular momentum (CAV). Never NaN:
  /// zero about axes without inertia.
  Eigen::Vector3d angular_velocity_rad_s = Eigen::Vector3d::Zero();
};
/// Computes momentum and inertia of the tree about its centre of mass;
/// docs/derivations/rigid_body.md eqs. (13)-(15).
Centroid centroid(TreeState& state);

/// Writes the centroidal momentum matrix (6 x n), angular rows first: momentum about the centre of
/// mass per unit of each velocity, so that matrix times velocity is (angular momentum, linear
/// momentum); eq. (16).
template <typename T>
void centroidal_momentum_matrix(TreeStateOf<T>& state, MatrixOutOf<T> out);

/// Kinetic energy v^T M v / 2 in J, with rotors as in M.
template <typename T>
T kinetic_energy_J(TreeStateOf<T>& state);
/// Potential energy in J; zero with all mass at the height of the world's origin.
template <typename T>
T potential_energy_J(const TreeStateOf<T>& state);

}  // namespace torquewright::dynamics
