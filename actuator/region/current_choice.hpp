// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/phase_model.hpp"

namespace torquewright::actuator {

/// How the drive places its current for a torque. docs/derivations/motor_region.md section 3.

/// The current of the greatest torque within the current limit, standing still (at MTPA).
Current greatest_torque_current(const PhaseModel& model);

/// Least current amplitude for the torque (maximum torque per ampere); its d part is zero where
/// L_d = L_q. Requires |torque| <= that of greatest_torque_current.
Current least_current(const PhaseModel& model, double torque_Nm);

/// The current for the torque at a speed that leaves the greatest voltage margin: least_current
/// without field weakening; else the d current that weakens the field most usefully within the
/// limits of current and demagnetisation.
Current gentlest_current(const PhaseModel& model, double torque_Nm, double speed_rad_s);

/// The current that the drive chooses: least_current where the voltage allows it, else the nearest
/// to it that the voltage allows, else gentlest_current (whose margin is then negative).
Current chosen_current(const PhaseModel& model, double torque_Nm, double speed_rad_s);

}  // namespace torquewright::actuator
