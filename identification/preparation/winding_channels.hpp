// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/preparation/channel_grid.hpp"
#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// Winding voltage in V, logged or duty times bus voltage (the nominal one where the bus was not
/// logged): through the low-pass, and what that removed; empty if neither was logged.
struct WindingVoltage {
  std::vector<double> filtered_V, fast_V;
};
WindingVoltage winding_voltage(ChannelGrid& grid, const actuator::Actuator& actuator);

/// Amperes of the bus per ampere in the motor's convention at full duty.
double bus_amperes_per_ampere(const actuator::Actuator& actuator);

/// Returns the winding temperature in K, or the case's, or the one at which the actuator's
/// constants hold.
std::vector<double> winding_temperature_K(ChannelGrid& grid, const actuator::Actuator& actuator);

/// Returns the current that the motor draws from the bus, in A: duty times current where a duty was
/// logged, else electrical power over bus voltage. Requires the signals' current, and bus_V of
/// their length.
std::vector<double> bus_current_A(ChannelGrid& grid, const actuator::Actuator& actuator,
                                  const Signals& signals);

}  // namespace torquewright::identification
