// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree_state.hpp"

namespace torquewright::dynamics {

/// The whole tree about its centre of mass, in the world's axes. A fixed base counts with its own
/// mass, as any body. Rotors count as rotor_spin_kg_m2 says: reflected inertia alone has energy but
/// no momentum.
struct Centroid {
  double mass_kg = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< From the world's origin.
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_momentum_Nm_s = Eigen::Vector3d::Zero();  ///< CAM.
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();  ///< Of all bodies as if they were one.
  /// CAV: with which that one body would have this angular momentum. NaN-free: zero about axes
  /// without inertia.
  Eigen::Vector3d angular_velocity_rad_s = Eigen::Vector3d::Zero();
};
/// docs/derivations/rigid_body.md eqs. (13)-(15).
Centroid centroid(TreeState& state);

/// (6 x n), angular rows first: momentum about the centre of mass per unit of each velocity, so
/// that matrix times velocity is (angular momentum, linear momentum); eq. (16).
template <typename T>
void centroidal_momentum_matrix(TreeStateOf<T>& state, MatrixOutOf<T> out);

/// v^T M v / 2, rotors as M has them.
template <typename T>
T kinetic_energy_J(TreeStateOf<T>& state);
/// Zero with all mass at the height of the world's origin.
template <typename T>
T potential_energy_J(const TreeStateOf<T>& state);

}  // namespace torquewright::dynamics
