// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// Least and greatest of a quantity over all angles of rotor and output.
struct Span {
  double least = 0.0;
  double greatest = 0.0;
};

/// Torque on the output, in Nm, of everything that acts on the motor's side of the mesh: drag and
/// cogging, over all angles. Drag opposes `direction`.
Span motor_side_torque_Nm(const Actuator& actuator, double speed_rad_s, double direction,
                          double temperature_K);

/// Torque on the load from torque before the mesh (both at the output): loss by the stated
/// efficiencies and by load_dependent_friction, driving where torque and direction agree. Infinite
/// where a self-locking gear is driven back. docs/derivations/motor_region.md eq. (12).
double after_mesh_Nm(const Actuator& actuator, double before_mesh_Nm, double direction);

/// The inverse of after_mesh_Nm.
double before_mesh_Nm(const Actuator& actuator, double after_mesh_Nm, double direction);

/// Torque at the output that varies with the output angle while `torque_Nm` is carried.
Span output_ripple_Nm(const Actuator& actuator, double torque_Nm);

}  // namespace torquewright::actuator
