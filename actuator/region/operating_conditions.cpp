// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/operating_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/effects/acting.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/envelope_region.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"

namespace torquewright::actuator {
namespace {

/// Torque at the joint over that of the motor as it brakes; no gearbox that can be turned at all
/// has more.
constexpr double kMostHeld = 1e3;

double cell_voltage_V(const Battery& battery, double state_of_charge) {
  const std::vector<ChargePoint>& curve = battery.cell_open_circuit;
  const auto above = std::find_if(curve.begin(), curve.end(), [&](const ChargePoint& point) {
    return point.state_of_charge >= state_of_charge;
  });
  if (above == curve.end()) return curve.back().voltage_V;
  if (above == curve.begin()) return curve.front().voltage_V;
  const ChargePoint& below = *(above - 1);
  const double share =
      (state_of_charge - below.state_of_charge) / (above->state_of_charge - below.state_of_charge);
  return below.voltage_V + share * (above->voltage_V - below.voltage_V);
}

/// Series resistance of everything between the open-circuit voltage and the drive.
double supply_resistance_ohm(const Actuator& actuator) {
  Instant at;
  at.bus_current_A = 1.0;
  double resistance_ohm = 0.0;
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->acts == Acts::kBusVoltage) resistance_ohm -= effect.kind->law(effect, at);
  }
  if (!actuator.battery) return resistance_ohm;
  const Battery& battery = *actuator.battery;
  return resistance_ohm + battery.wiring_resistance_ohm +
         battery.cell_resistance_ohm * battery.series_cells / battery.parallel_cells;
}

/// Power at the drive when that current flows out of the supply.
double power_at_W(const Supply& supply, double current_A) {
  return current_A * (supply.open_circuit_V - supply.resistance_ohm * current_A);
}

Supply supply_at(const Actuator& actuator, const OperatingConditions& conditions) {
  Supply supply;
  supply.open_circuit_V = open_circuit_voltage_V(actuator, conditions);
  supply.resistance_ohm = supply_resistance_ohm(actuator);
  supply.greatest_power_W = kUnlimited;
  supply.least_power_W = actuator.drive.regeneration ? -actuator.drive.regeneration_limit_W : 0.0;
  const double pack_limit_A = actuator.battery ? actuator.battery->discharge_limit_A : kUnlimited;
  const double limit_A = std::min(pack_limit_A, actuator.drive.supply_current_A);
  // From half the short circuit's current on more current is less power: there the source limits.
  if (limit_A < kUnlimited && 2.0 * supply.resistance_ohm * limit_A < supply.open_circuit_V) {
    supply.greatest_power_W = power_at_W(supply, limit_A);
  }
  if (!actuator.battery) return supply;
  const Battery& battery = *actuator.battery;
  if (battery.charge_limit_A < kUnlimited) {
    supply.least_power_W =
        std::max(supply.least_power_W, power_at_W(supply, -battery.charge_limit_A));
  }
  if (battery.maximum_voltage_V < kUnlimited && supply.resistance_ohm > 0.0) {
    const double room_V = std::max(0.0, battery.maximum_voltage_V - supply.open_circuit_V);
    supply.least_power_W =
        std::max(supply.least_power_W, power_at_W(supply, -room_V / supply.resistance_ohm));
  }
  return supply;
}

void set_saturation(const Actuator& actuator, PhaseModel& model) {
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->saturation == nullptr) continue;
    const Saturation saturation = effect.kind->saturation(effect);
    if (!std::isfinite(saturation.current_A)) continue;
    model.saturation_current_A =
        saturation.current_A * phase_amperes_per_ampere(actuator.motor.torque_constant_convention);
    model.saturation_exponent = saturation.exponent;
  }
}

double dead_time_V(const Actuator& actuator) {
  Instant at;
  at.current_A = 1.0;
  double lost_V = 0.0;
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->acts == Acts::kWindingVoltage) lost_V -= effect.kind->law(effect, at);
  }
  return lost_V * phase_volts_per_winding_volt(actuator.motor.torque_constant_convention);
}

/// A wrong torque constant is wrong at every current: what the law gives at no current.
double torque_constant_factor(const Actuator& actuator) {
  const Instant at = at_winding_temperature(actuator, actuator.motor.winding_temperature_K);
  return product_of_laws(actuator.effects, Acts::kTorqueFactor, at);
}

void set_constants(const Actuator& actuator, double temperature_K, PhaseModel& model) {
  const Motor& motor = actuator.motor;
  const CurrentConvention convention = motor.torque_constant_convention;
  const double flux = flux_factor(actuator, at_winding_temperature(actuator, temperature_K));
  const double torque_constant_Nm_A = motor.torque_constant_Nm_A * torque_constant_factor(actuator);
  const double back_emf_V_s_rad = back_emf_constant_V_s_rad(actuator);
  model.torque_constant_Nm_A = flux * torque_constant_Nm_A / phase_amperes_per_ampere(convention);
  model.back_emf_V_s_rad = flux * back_emf_V_s_rad * phase_volts_per_winding_volt(convention);
  model.resistance_ohm = phase_resistance_ohm(actuator, temperature_K);
  model.inductance_d_H = motor.inductance_d_H;
  model.inductance_q_H = motor.inductance_q_H;
  model.pole_pairs = motor.pole_pairs;
  model.dead_time_V = dead_time_V(actuator);
  set_saturation(actuator, model);
}

void set_current_limit(const Actuator& actuator, Rating rating, PhaseModel& model) {
  const double per_ampere = phase_amperes_per_ampere(actuator.motor.torque_constant_convention);
  double limit_A = actuator.drive.peak_current_A;
  if (rating == Rating::kContinuous) {
    const double stated_A = actuator.drive.continuous_current_A.value_or(kUnlimited);
    const double steady_A = steady_current_A(actuator).value_or(kUnlimited);
    if (std::min(stated_A, steady_A) < limit_A && steady_A < stated_A) {
      model.current_limiter = Limiter::kThermal;
    }
    limit_A = std::min({limit_A, stated_A, steady_A});
  }
  model.current_limit_A = limit_A * per_ampere;
  model.demagnetisation_current_A = actuator.motor.demagnetisation_current_A * per_ampere;
}

/// What a curve alone does not say.
std::vector<std::string> envelope_objections(const Envelope& envelope,
                                             const OperatingConditions& conditions) {
  std::vector<std::string> sentences;
  if (conditions.rating == Rating::kContinuous && !envelope.continuous) {
    sentences.push_back(
        "the continuous rating needs /envelope/continuous_torque_Nm or "
        "/envelope/continuous_points; the document has neither");
  }
  if (conditions.bus_voltage_V && !envelope.voltage_V) {
    sentences.push_back(
        "another bus voltage needs /envelope/voltage_V, at which the curve holds, or a winding "
        "(/motor and /drive)");
  }
  if (conditions.state_of_charge) {
    sentences.push_back("a state of charge needs a winding and a battery (/motor, /battery)");
  }
  if (conditions.winding_temperature_K) {
    sentences.push_back("a winding's temperature needs a winding (/motor and /drive)");
  }
  return sentences;
}

}  // namespace

std::vector<std::string> objections(const Actuator& actuator,
                                    const OperatingConditions& conditions) {
  std::vector<std::string> sentences;
  if (actuator.envelope) return envelope_objections(*actuator.envelope, conditions);
  const bool has_rating = actuator.drive.continuous_current_A || actuator.thermal;
  if (conditions.rating == Rating::kContinuous && !has_rating) {
    sentences.push_back(
        "the continuous rating needs /drive/continuous_current_A or /thermal; the document has "
        "neither");
  }
  if (conditions.state_of_charge && conditions.bus_voltage_V) {
    sentences.push_back("a bus voltage and a state of charge were asked for; one sets the other");
  } else if (conditions.state_of_charge &&
             (!actuator.battery || actuator.battery->cell_open_circuit.size() < 2)) {
    sentences.push_back(
        "a state of charge needs /battery/cell_open_circuit_V as a list of {state_of_charge, "
        "voltage_V}; the document has no such curve");
  } else if (conditions.state_of_charge) {
    const double least = actuator.battery->cell_open_circuit.front().state_of_charge;
    const double most = actuator.battery->cell_open_circuit.back().state_of_charge;
    if (*conditions.state_of_charge < least || *conditions.state_of_charge > most) {
      sentences.push_back(
          fmt::format("a state of charge of {} lies outside of the battery's curve, which is known "
                      "from {} to {} "
                      "(/battery/cell_open_circuit_V)",
                      *conditions.state_of_charge, least, most));
    }
  }
  const double temperature_K = winding_temperature_K(actuator, conditions);
  const Instant warm = at_winding_temperature(actuator, temperature_K);
  if (resistance_factor(actuator, warm) <= 0.0 || flux_factor(actuator, warm) <= 0.0) {
    sentences.push_back(
        fmt::format("at a winding temperature of {:.6g} K the temperature coefficients leave no "
                    "resistance or no "
                    "magnet; the laws are linear about {:.6g} K",
                    temperature_K, actuator.motor.winding_temperature_K));
  }
  const double held = after_mesh_Nm(actuator, 1.0, -1.0);
  if (held > kMostHeld && actuator.transmission.peak_torque_Nm == kUnlimited) {
    sentences.push_back(fmt::format(
        "the gearbox locks itself: braking torque is held by its teeth, not by the motor{}; state "
        "/gearbox/peak_torque_Nm",
        std::isfinite(held) ? fmt::format(" ({:.3g} times what the motor gives)", held) : ""));
  }
  return sentences;
}

double winding_temperature_K(const Actuator& actuator, const OperatingConditions& conditions) {
  return conditions.winding_temperature_K.value_or(actuator.motor.winding_temperature_K);
}

double open_circuit_voltage_V(const Actuator& actuator, const OperatingConditions& conditions) {
  if (conditions.bus_voltage_V) return *conditions.bus_voltage_V;
  if (!actuator.battery) return actuator.drive.bus_voltage_V;
  return actuator.battery->series_cells *
         cell_voltage_V(*actuator.battery, conditions.state_of_charge.value_or(1.0));
}

std::optional<double> steady_current_A(const Actuator& actuator) {
  if (!actuator.thermal) return std::nullopt;
  const Thermal& thermal = *actuator.thermal;
  const double room_K = thermal.winding_limit_K - thermal.ambient_K;
  if (room_K <= 0.0) return 0.0;
  const double loss_W = room_K / (thermal.winding_to_case_K_W + thermal.case_to_ambient_K_W);
  const double resistance_ohm = phase_resistance_ohm(actuator, thermal.winding_limit_K);
  return std::sqrt(loss_W / (1.5 * resistance_ohm)) /
         phase_amperes_per_ampere(actuator.motor.torque_constant_convention);
}

namespace {

/// Of a drive of which only the curve is known: its currents are torques, and neither heat nor
/// losses follow from it.
PhaseModel envelope_model(const Actuator& actuator, const OperatingConditions& conditions) {
  PhaseModel model;
  const double bus_V = open_circuit_voltage_V(actuator, conditions);
  const Envelope& envelope = *actuator.envelope;
  const bool lasts = conditions.rating == Rating::kContinuous;
  model.envelope = std::make_shared<const EnvelopeCurve>(
      rotor_envelope(actuator, lasts ? *envelope.continuous : envelope.peak, bus_V,
                     winding_temperature_K(actuator, conditions)));
  model.torque_constant_Nm_A = 1.0;
  model.current_limit_A = greatest_torque_Nm(*model.envelope);
  model.current_limiter = Limiter::kEnvelope;
  model.demagnetisation_current_A = kUnlimited;
  model.supply.open_circuit_V = bus_V;
  model.supply.greatest_power_W = kUnlimited;
  model.supply.least_power_W = -kUnlimited;
  model.phase_volts_per_bus_volt = 1.0;
  return model;
}

}  // namespace

PhaseModel phase_model_at(const Actuator& actuator, const OperatingConditions& conditions) {
  if (actuator.envelope) return envelope_model(actuator, conditions);
  PhaseModel model;
  set_constants(actuator, winding_temperature_K(actuator, conditions), model);
  set_current_limit(actuator, conditions.rating, model);
  model.field_weakening = actuator.drive.field_weakening;
  model.supply = supply_at(actuator, conditions);
  model.phase_volts_per_bus_volt = phase_volts_per_bus_volt(
      actuator.motor.torque_constant_convention, actuator.drive.modulation);
  return model;
}

}  // namespace torquewright::actuator
