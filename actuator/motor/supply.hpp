// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace torquewright::actuator {

/// What feeds the drive: a source behind a resistance, with limits. Stiff where resistance is 0.
struct Supply {
  double open_circuit_V = 0.0;
  double resistance_ohm = 0.0;
  double greatest_power_W = 0.0;  ///< Into the drive; may be infinite.
  double least_power_W = 0.0;     ///< Negative: back into the supply; may be minus infinity.
};

/// Bus voltage while the drive takes that power (negative: returns it): the larger root of
/// V^2 - Voc V + R P = 0. Empty where 4 R P > Voc^2: the supply cannot deliver it.
/// docs/derivations/motor_region.md eq. (5).
std::optional<double> bus_voltage_V(const Supply& supply, double power_W);

}  // namespace torquewright::actuator
