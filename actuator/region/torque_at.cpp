// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/torque_at.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/effects/acting.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/gear_losses.hpp"

namespace torquewright::actuator {
double motor_torque_Nm(const Actuator& actuator, const Instant& at) {
  return actuator.transmission.ratio * actuator.motor.torque_constant_Nm_A * at.current_A *
         product_of_laws(actuator.effects, Acts::kTorqueFactor, at) * flux_factor(actuator, at);
}

double drag_Nm(const Actuator& actuator, const Instant& at) {
  const double drag = sum_of_laws(actuator.effects, Acts::kDrag, at);
  return drag == 0.0 ? 0.0 : drag * drag_factor(actuator, at);
}

double periodic_motor_torque_Nm(const Actuator& actuator, const Instant& at) {
  return sum_of_laws(actuator.effects, Acts::kMotorSideTorque, at);
}

double reflected_inertia_kg_m2(const Actuator& actuator) {
  Instant unit;
  unit.acceleration_rad_s2 = 1.0;
  const double ratio = actuator.transmission.ratio;
  return ratio * ratio * actuator.motor.rotor_inertia_kg_m2 + actuator.transmission.inertia_kg_m2 -
         sum_of_laws(actuator.effects, Acts::kInertialTorque, unit);
}

double before_gears_kg_m2(const Actuator& actuator) {
  return reflected_inertia_kg_m2(actuator) - actuator.transmission.inertia_kg_m2;
}

double before_mesh_at_Nm(const Actuator& actuator, const Instant& at) {
  return motor_torque_Nm(actuator, at) + drag_Nm(actuator, at) +
         periodic_motor_torque_Nm(actuator, at) -
         reflected_inertia_kg_m2(actuator) * at.acceleration_rad_s2;
}

double output_torque_Nm(const Actuator& actuator, const Instant& at) {
  Instant loaded = at;
  loaded.load_torque_Nm = after_mesh_Nm(actuator, before_mesh_at_Nm(actuator, at), at.direction);
  return loaded.load_torque_Nm + ripple_Nm(actuator, loaded);
}

double ripple_Nm(const Actuator& actuator, const Instant& at) {
  return sum_of_laws(actuator.effects, Acts::kOutputTorque, at);
}

double back_emf_constant_V_s_rad(const Actuator& actuator) {
  const Motor& motor = actuator.motor;
  // A wrong torque constant is wrong at every current: what the law gives at none.
  return motor.back_emf_constant_V_s_rad.value_or(
      motor.torque_constant_Nm_A * product_of_laws(actuator.effects, Acts::kTorqueFactor, {}) *
      back_emf_per_torque_constant(motor.torque_constant_convention));
}

double drag_factor(const Actuator& actuator, const Instant& at) {
  return std::max(0.0, product_of_laws(actuator.effects, Acts::kDragFactor, at));
}

double winding_voltage_change_V(const Actuator& actuator, const Instant& at) {
  return sum_of_laws(actuator.effects, Acts::kWindingVoltage, at);
}

double bus_voltage_change_V(const Actuator& actuator, const Instant& at) {
  return sum_of_laws(actuator.effects, Acts::kBusVoltage, at);
}

}  // namespace torquewright::actuator
