// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// The torque balance of an actuator at one instant, by the order of losses of
/// docs/derivations/motor_region.md eq. (12). Everything in Nm at the output. Effects with a state
/// (Acts::kDynamics) take no part: who simulates them adds them.

/// N Kt i, with every effect on the torque constant.
double motor_torque_Nm(const Actuator& actuator, const Instant& at);

/// Friction that does not depend on load, with its sign (against the motion).
double drag_Nm(const Actuator& actuator, const Instant& at);

/// Cogging and the like, before the mesh.
double periodic_motor_torque_Nm(const Actuator& actuator, const Instant& at);

/// Inertia of rotor and gears at the output, with what effects add, in kg m^2.
double reflected_inertia_kg_m2(const Actuator& actuator);

/// The part of reflected_inertia_kg_m2() that turns before the mesh: without the gears' own.
double before_gears_kg_m2(const Actuator& actuator);

/// Torque before the mesh: motor, drag, cogging, and what accelerates the rotor.
double before_mesh_at_Nm(const Actuator& actuator, const Instant& at);

/// Torque on the load: the above through the mesh, with the ripple of the output.
double output_torque_Nm(const Actuator& actuator, const Instant& at);

/// What of the torque on the load repeats with the output's angle; `at.load_torque_Nm` is what
/// comes through the mesh.
double ripple_Nm(const Actuator& actuator, const Instant& at);

/// The motor's back-EMF constant in the winding's convention, before the flux's factors: as the
/// document states it, else what goes with the torque constant, an error of which it then shares
/// (one flux makes both).
double back_emf_constant_V_s_rad(const Actuator& actuator);

/// Factor of every effect on all drag.
double drag_factor(const Actuator& actuator, const Instant& at);

/// Voltage that is lost between drive and winding, with its sign; change of the bus voltage.
double winding_voltage_change_V(const Actuator& actuator, const Instant& at);
double bus_voltage_change_V(const Actuator& actuator, const Instant& at);

}  // namespace torquewright::actuator
