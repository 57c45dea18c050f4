// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/winding.hpp"

#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/torque_at.hpp"

namespace torquewright::actuator {

Winding winding_of(const Actuator& actuator) {
  const Motor& motor = actuator.motor;
  const auto convention = motor.torque_constant_convention;
  const double amperes = phase_amperes_per_ampere(convention);
  // V [winding] per phase volt, and the phase's line R i + Ke w in the document's convention.
  const double volts = phase_volts_per_winding_volt(convention);
  const double phase_ohm = motor.resistance_ohm * phase_ohms_per_ohm(motor.resistance_convention);
  return {phase_ohm * amperes / volts, back_emf_constant_V_s_rad(actuator)};
}

double resistance_ohm(const Actuator& actuator, const Winding& winding, const Instant& at) {
  return winding.resistance_ohm * resistance_factor(actuator, at);
}

}  // namespace torquewright::actuator
