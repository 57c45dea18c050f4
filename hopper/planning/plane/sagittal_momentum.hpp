// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/plane/sagittal_robot.hpp"

namespace torquewright::hopper {

/// Momentum of the whole robot about its centre of mass and about +y
/// (docs/derivations/rigid_body.md eqs. (13), (14), (16)); rotors count as there.
template <typename T>
struct SagittalMomentumOf {
  T angular_Nm_s;   ///< Angular momentum (CAM).
  T inertia_kg_m2;  ///< Inertia of all bodies as if they were one.
  T average_rad_s() const { return angular_Nm_s / inertia_kg_m2; }  ///< CAV.
};

/// Computes the momentum from the base's pitch and the joints that move (m - 2), and their rates;
/// the place and its rate do not matter. For double and numbers with derivatives of first and
/// second order.
template <typename T>
SagittalMomentumOf<T> sagittal_momentum(const SagittalRobot& robot,
                                        const dynamics::VectorX<T>& posture_rad,
                                        const dynamics::VectorX<T>& rates_rad_s);

}  // namespace torquewright::hopper
