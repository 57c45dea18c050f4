// SPDX-License-Identifier: Apache-2.0
#include "identification/preparation/winding_channels.hpp"

#include "actuator/region/winding.hpp"

namespace torquewright::identification {
namespace {

/// Electrical power per volt (as windings count it) and ampere of the convention: 1 for the
/// equivalent winding, 3/2 for amplitudes, times sqrt 2 where the ampere is an rms one.
double power_factor(actuator::CurrentConvention convention) {
  if (convention == actuator::CurrentConvention::kDc) return 1.0;
  return 1.5 * actuator::phase_amperes_per_ampere(convention);
}

}  // namespace

double bus_amperes_per_ampere(const actuator::Actuator& actuator) {
  return power_factor(actuator.motor.torque_constant_convention);
}

WindingVoltage winding_voltage(ChannelGrid& grid, const actuator::Actuator& actuator) {
  const bool is_voltage = grid.has(Quantity::kWindingVoltage);
  if (!is_voltage && !grid.has(Quantity::kDuty)) return {};
  WindingVoltage voltage;
  voltage.fast_V = grid.read_unfiltered(is_voltage ? Quantity::kWindingVoltage : Quantity::kDuty);
  voltage.filtered_V = grid.filtered(voltage.fast_V);
  for (std::size_t i = 0; i < voltage.fast_V.size(); ++i) {
    voltage.fast_V[i] -= voltage.filtered_V[i];
  }
  if (is_voltage) return voltage;
  const std::vector<double> bus = grid.read_or(Quantity::kBusVoltage, actuator.drive.bus_voltage_V);
  for (std::size_t i = 0; i < bus.size(); ++i) {
    voltage.filtered_V[i] *= bus[i];
    voltage.fast_V[i] *= bus[i];
  }
  return voltage;
}

std::vector<double> winding_temperature_K(ChannelGrid& grid, const actuator::Actuator& actuator) {
  if (grid.has(Quantity::kWindingTemperature)) return grid.read(Quantity::kWindingTemperature);
  return grid.read_or(Quantity::kCaseTemperature, actuator.motor.winding_temperature_K);
}

std::vector<double> bus_current_A(ChannelGrid& grid, const actuator::Actuator& actuator,
                                  const Signals& signals) {
  const double factor = power_factor(actuator.motor.torque_constant_convention);
  const actuator::Winding winding = actuator::winding_of(actuator);
  const double ratio = actuator.transmission.ratio;
  const std::vector<double> duty = grid.read_if_any(Quantity::kDuty);
  std::vector<double> current(signals.size());
  for (std::size_t i = 0; i < current.size(); ++i) {
    const actuator::Instant& at = signals.at[i];
    const double volts = !signals.voltage_V.empty()
                             ? signals.voltage_V[i]
                             : winding.resistance_ohm * at.current_A +
                                   winding.back_emf_V_s_rad * ratio * at.speed_rad_s;
    current[i] = factor * at.current_A * (duty.empty() ? volts / signals.bus_V[i] : duty[i]);
  }
  return current;
}

}  // namespace torquewright::identification
