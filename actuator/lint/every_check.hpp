// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/lint/check.hpp"

namespace torquewright::actuator::lint {

/// Each is defined in the file of its name, or of its subject.
extern const Check no_load_speed;
extern const Check maximum_speed;
extern const Check no_load_current;
extern const Check back_emf_constant;
extern const Check velocity_constant;
extern const Check stall_current;
extern const Check stall_torque;
extern const Check peak_torque;
extern const Check peak_torque_current;
extern const Check peak_braking_torque;
extern const Check rated_torque;
extern const Check peak_power;
extern const Check reflected_inertia;
extern const Check continuous_current;
extern const Check rated_torque_heat;
extern const Check bus_voltage;
extern const Check charge_voltage;
extern const Check gear_backlash;
extern const Check gear_limit;
extern const Check motor_against_gear;
extern const Check backward_efficiency;
extern const Check electrical_time_constant;
extern const Check mechanical_time_constant;
extern const Check winding_inductance;
extern const Check characteristic_current;
extern const Check magnet_limit;
extern const Check torque_constant_unit;

}  // namespace torquewright::actuator::lint
