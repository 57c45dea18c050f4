// SPDX-License-Identifier: Apache-2.0
#include "simulation/joint/winding_circuit.hpp"

#include <algorithm>

#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/torque_at.hpp"
#include "simulation/sign.hpp"

namespace torquewright::simulation {

using actuator::Instant;

WindingCircuit::WindingCircuit(const actuator::Actuator& actuator, bool inductance)
    : actuator_(actuator), winding_(actuator::winding_of(actuator)) {
  if (!inductance) return;
  const auto convention = actuator.motor.torque_constant_convention;
  inductance_H_ = actuator.motor.inductance_q_H * actuator::phase_amperes_per_ampere(convention) /
                  actuator::phase_volts_per_winding_volt(convention);
}

double WindingCircuit::applied_V(const JointState& state, const DriveNow& drive,
                                 double bus_V) const {
  if (drive.kind == DriveKind::kVoltage) return drive.value;
  const double duty = drive.kind == DriveKind::kDuty
                          ? drive.value
                          : drive.position_gain_1_rad * (drive.value - state.position_rad);
  return std::clamp(duty, -1.0, 1.0) * bus_V;
}

double WindingCircuit::quasi_static_A(const JointState& state, const DriveNow& drive,
                                      double bus_V) const {
  Instant at = instant_of(actuator_, state, 0.0);
  const double back_emf_V = winding_.back_emf_V_s_rad * actuator::flux_factor(actuator_, at) *
                            actuator_.transmission.ratio * state.motor_speed_rad_s;
  const double left_V = applied_V(state, drive, bus_V) - back_emf_V;
  const double resistance = actuator::resistance_ohm(actuator_, winding_, at);
  // What the bridge loses opposes the current; where it exceeds what is left, none flows.
  at.current_A = sign_of(left_V);
  const double driving_V = left_V + actuator::winding_voltage_change_V(actuator_, at);
  return driving_V * at.current_A > 0.0 ? driving_V / resistance : 0.0;
}

WindingCircuit::Rate WindingCircuit::current_rate(const JointState& state,
                                                  const DriveNow& drive) const {
  const Instant at = instant_of(actuator_, state, sign_of(state.motor_speed_rad_s));
  const double resistance = actuator::resistance_ohm(actuator_, winding_, at);
  // L di/dt = R (i that the voltage would drive in the long run - i).
  const double bus = bus_V(state, drive, state.current_A);
  const double settled_A = quasi_static_A(state, drive, bus);
  const double slope = -resistance / inductance_H_;
  return {slope * (state.current_A - settled_A), slope};
}

double WindingCircuit::bus_V(const JointState& state, const DriveNow& drive,
                             double current_A) const {
  if (drive.bus_V) return *drive.bus_V;
  const double open_V = actuator_.drive.bus_voltage_V;
  const double volts = voltage_V(state, drive, current_A);
  Instant at = instant_of(actuator_, state, 0.0);
  // Bus current = duty times winding current, duty = volts over the bus voltage: a few rounds.
  double bus = open_V;
  for (int round = 0; round < 4; ++round) {
    const double duty = drive.kind == DriveKind::kDuty ? drive.value : volts / bus;
    at.bus_current_A = duty * current_A;
    bus = std::max(0.1 * open_V, open_V + actuator::bus_voltage_change_V(actuator_, at));
  }
  return bus;
}

double WindingCircuit::current_A(const JointState& state, const DriveNow& drive) const {
  switch (drive.kind) {
    case DriveKind::kCurrent:
      return drive.value;
    case DriveKind::kTorque:
      return drive.value / (actuator_.transmission.ratio * actuator_.motor.torque_constant_Nm_A);
    case DriveKind::kPositionLaw:
      return drive.law.torque_Nm(drive.value, state.position_rad, state.speed_rad_s) /
             (actuator_.transmission.ratio * actuator_.motor.torque_constant_Nm_A);
    default:
      break;
  }
  if (inductance_H_ > 0.0) return state.current_A;
  const double open_V = drive.bus_V.value_or(actuator_.drive.bus_voltage_V);
  const double first_A = quasi_static_A(state, drive, open_V);
  if (drive.bus_V || drive.kind == DriveKind::kVoltage) return first_A;
  // The bus falls with the current, the current with the bus: affine, so one step of Aitken's.
  const double second_A = quasi_static_A(state, drive, bus_V(state, drive, first_A));
  const double third_A = quasi_static_A(state, drive, bus_V(state, drive, second_A));
  const double curve_A = third_A - 2.0 * second_A + first_A;
  return curve_A == 0.0 ? third_A : first_A - (second_A - first_A) * (second_A - first_A) / curve_A;
}

double WindingCircuit::voltage_V(const JointState& state, const DriveNow& drive,
                                 double current_A) const {
  if (drive.kind == DriveKind::kVoltage) return drive.value;
  Instant at = instant_of(actuator_, state, 0.0);
  at.current_A = current_A;
  return actuator::resistance_ohm(actuator_, winding_, at) * current_A +
         winding_.back_emf_V_s_rad * actuator::flux_factor(actuator_, at) *
             actuator_.transmission.ratio * state.motor_speed_rad_s -
         actuator::winding_voltage_change_V(actuator_, at);
}

}  // namespace torquewright::simulation
