// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/phase_model.hpp"

#include <cmath>

#include "actuator/unlimited.hpp"

namespace torquewright::actuator {
namespace {

double saturation(const PhaseModel& model, double q_A) {
  if (model.saturation_current_A == 0.0) return 1.0;
  const double p = model.saturation_exponent;
  return std::pow(1.0 + std::pow(std::abs(q_A) / model.saturation_current_A, p), -1.0 / p);
}

}  // namespace

std::string_view name_of(Limiter limiter) {
  switch (limiter) {
    case Limiter::kCurrent:
      return "current";
    case Limiter::kVoltage:
      return "voltage";
    case Limiter::kFieldWeakening:
      return "field_weakening";
    case Limiter::kRegeneration:
      return "regeneration";
    case Limiter::kBatteryPower:
      return "battery_power";
    case Limiter::kGear:
      return "gear";
    case Limiter::kThermal:
      return "thermal";
    case Limiter::kEnvelope:
      return "envelope";
    case Limiter::kDemagnetisation:
      break;
  }
  return "demagnetisation";
}

double Current::amplitude_A() const { return d_A == 0.0 ? std::abs(q_A) : std::hypot(d_A, q_A); }

double PhaseModel::reluctance_Nm_A2() const {
  return 1.5 * pole_pairs * (inductance_d_H - inductance_q_H);
}

double torque_Nm(const PhaseModel& model, const Current& current) {
  const double per_ampere = model.torque_constant_Nm_A + model.reluctance_Nm_A2() * current.d_A;
  return saturation(model, current.q_A) * per_ampere * current.q_A;
}

double q_current_A(const PhaseModel& model, double torque_Nm, double d_A) {
  const double per_ampere = model.torque_constant_Nm_A + model.reluctance_Nm_A2() * d_A;
  if (torque_Nm == 0.0) return 0.0;
  if (per_ampere <= 0.0) return kUnlimited;
  const double linear_A = torque_Nm / per_ampere;
  if (model.saturation_current_A == 0.0) return linear_A;
  const double p = model.saturation_exponent;
  const double filled = std::pow(std::abs(linear_A) / model.saturation_current_A, p);
  return filled >= 1.0 ? std::copysign(kUnlimited, torque_Nm)
                       : linear_A * std::pow(1.0 - filled, -1.0 / p);
}

double copper_loss_W(const PhaseModel& model, const Current& current) {
  return 1.5 * model.resistance_ohm * (current.d_A * current.d_A + current.q_A * current.q_A);
}

double induced_Nm(const PhaseModel& model, const Current& current) {
  return 1.5 * model.back_emf_V_s_rad * current.q_A +
         model.reluctance_Nm_A2() * current.d_A * current.q_A;
}

double bus_power_W(const PhaseModel& model, const Current& current, double speed_rad_s) {
  return induced_Nm(model, current) * speed_rad_s + copper_loss_W(model, current) +
         1.5 * model.dead_time_V * current.amplitude_A();
}

double phase_voltage_V(const PhaseModel& model, const Current& current, double speed_rad_s) {
  const double electrical_rad_s = model.pole_pairs * speed_rad_s;
  const double amplitude_A = current.amplitude_A();
  // The bridge loses a voltage along the current, like a further drop over the resistance.
  const double drop_ohm =
      model.resistance_ohm + (amplitude_A > 0.0 ? model.dead_time_V / amplitude_A : 0.0);
  const double d_V = drop_ohm * current.d_A - electrical_rad_s * model.inductance_q_H * current.q_A;
  const double q_V = drop_ohm * current.q_A +
                     electrical_rad_s * model.inductance_d_H * current.d_A +
                     model.back_emf_V_s_rad * speed_rad_s;
  return d_V == 0.0 ? std::abs(q_V) : std::hypot(d_V, q_V);
}

double voltage_margin_V(const PhaseModel& model, const Current& current, double speed_rad_s) {
  const std::optional<double> bus_V =
      bus_voltage_V(model.supply, bus_power_W(model, current, speed_rad_s));
  if (!bus_V) return -kUnlimited;
  return model.phase_volts_per_bus_volt * *bus_V - phase_voltage_V(model, current, speed_rad_s);
}

}  // namespace torquewright::actuator
