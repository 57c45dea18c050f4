// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/motor/phase_model.hpp"

namespace torquewright::actuator {

/// The d currents that are best for a torque, by Newton's method with a bisection for what it might
/// overshoot.
/// docs/derivations/motor_region.md section 3.

/// Whether the voltage margin has one top along a line of constant torque: without dead time, whose
/// voltage turns with the current.
bool has_smooth_choice(const PhaseModel& model);

/// Returns the d current between two at which the torque takes the least current.
double least_current_d_A(const PhaseModel& model, double torque_Nm, double low_A, double high_A);

/// Returns the d current between two at which the torque leaves the greatest voltage margin.
/// Requires has_smooth_choice, and that |i| grows from high_A to low_A.
double greatest_margin_d_A(const PhaseModel& model, double torque_Nm, double speed_rad_s,
                           double low_A, double high_A);

/// The first d current below from_A, where the voltage does not suffice for the torque, at which it
/// does: the room is concave, so that Newton's method comes near it from above. Empty where it
/// finds none.
std::optional<double> first_room_d_A(const PhaseModel& model, double torque_Nm, double speed_rad_s,
                                     double from_A);

/// d current of the greatest torque at the current limit, standing still; at least low_A.
double greatest_torque_d_A(const PhaseModel& model, double low_A);

}  // namespace torquewright::actuator
