// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/every_check.hpp"

namespace torquewright::actuator::lint {

std::span<const Check* const> library() {
  static constexpr const Check* kChecks[] = {
      &no_load_speed,
      &maximum_speed,
      &no_load_current,
      &back_emf_constant,
      &velocity_constant,
      &stall_current,
      &stall_torque,
      &peak_torque,
      &peak_torque_current,
      &peak_braking_torque,
      &rated_torque,
      &peak_power,
      &reflected_inertia,
      &continuous_current,
      &rated_torque_heat,
      &bus_voltage,
      &charge_voltage,
      &gear_backlash,
      &gear_limit,
      &motor_against_gear,
      &backward_efficiency,
      &electrical_time_constant,
      &mechanical_time_constant,
      &winding_inductance,
      &characteristic_current,
      &magnet_limit,
      &torque_constant_unit,
  };
  return kChecks;
}

}  // namespace torquewright::actuator::lint
