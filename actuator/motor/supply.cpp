// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/supply.hpp"

#include <cmath>

namespace torquewright::actuator {

std::optional<double> bus_voltage_V(const Supply& supply, double power_W) {
  if (supply.resistance_ohm == 0.0) return supply.open_circuit_V;
  const double open_V = supply.open_circuit_V;
  const double discriminant = open_V * open_V - 4.0 * supply.resistance_ohm * power_W;
  if (discriminant < 0.0) return std::nullopt;
  return 0.5 * (open_V + std::sqrt(discriminant));
}

}  // namespace torquewright::actuator
