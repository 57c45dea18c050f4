// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/demand.hpp"

#include <cmath>

#include "actuator/region/current_choice.hpp"
#include "actuator/region/gear_losses.hpp"

namespace torquewright::actuator {

// tau_m = (tau / mesh - side) / N.
double rotor_torque_Nm(const Actuator& actuator, double temperature_K, double speed_rad_s,
                       double torque_Nm) {
  const bool is_at_rest = speed_rad_s == 0.0;
  const double direction =
      is_at_rest ? -std::copysign(1.0, torque_Nm) : std::copysign(1.0, speed_rad_s);
  const double mesh_Nm = before_mesh_Nm(actuator, torque_Nm, direction);
  const Span side = motor_side_torque_Nm(actuator, speed_rad_s, direction, temperature_K);
  const double before_Nm = mesh_Nm - 0.5 * (side.least + side.greatest);
  // Friction holds a load at rest, it does not move it, nor anything without a load.
  if (is_at_rest && before_Nm * torque_Nm <= 0.0) return 0.0;
  return before_Nm / actuator.transmission.ratio;
}

std::optional<Demand> demand_at(const Actuator& actuator, const PhaseModel& model,
                                double temperature_K, double speed_rad_s, double torque_Nm) {
  const double motor_Nm = rotor_torque_Nm(actuator, temperature_K, speed_rad_s, torque_Nm);
  const double motor_rad_s = actuator.transmission.ratio * speed_rad_s;
  const Current current = chosen_current(model, motor_Nm, motor_rad_s);
  Demand demand;
  demand.motor_torque_Nm = motor_Nm;
  demand.phase_current_A = current.amplitude_A();
  if (!std::isfinite(demand.phase_current_A)) return std::nullopt;
  demand.current_A =
      demand.phase_current_A / phase_amperes_per_ampere(actuator.motor.torque_constant_convention);
  demand.bus_power_W = bus_power_W(model, current, motor_rad_s);
  const Current gentlest = gentlest_current(model, motor_Nm, motor_rad_s);
  demand.voltage_margin_V =
      voltage_margin_V(model, gentlest, motor_rad_s) / model.phase_volts_per_bus_volt;
  return demand;
}

}  // namespace torquewright::actuator
