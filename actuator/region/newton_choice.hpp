// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/phase_model.hpp"

namespace torquewright::actuator {

/// The d currents that are best for a torque, by Newton's method with a bisection for what it might
/// overshoot; for machines whose q current is torque over a straight line in i_d.
/// docs/derivations/motor_region.md section 3.

/// Whether the functions below hold for the model: no dead time, and saturation only with equal
/// inductances.
bool has_smooth_choice(const PhaseModel& model);

/// Where |i| is least for the torque. Requires has_smooth_choice.
double least_current_d_A(const PhaseModel& model, double torque_Nm, double low_A, double high_A);

/// Where the voltage margin is greatest for the torque. Requires has_smooth_choice, and that |i|
/// grows from high_A to low_A.
double greatest_margin_d_A(const PhaseModel& model, double torque_Nm, double speed_rad_s,
                           double low_A, double high_A);

/// d current of the greatest torque at the current limit, standing still. Requires no saturation.
double greatest_torque_d_A(const PhaseModel& model);

}  // namespace torquewright::actuator
