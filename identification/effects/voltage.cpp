// SPDX-License-Identifier: Apache-2.0
// What the drive takes of the voltage that was asked for.
#include "identification/effects/families.hpp"

namespace torquewright::identification {

void add_voltage(DictionaryBuilder& builder) {
  const Bench& bench = builder.bench();
  if (bench.drive != Drive::kVoltage || bench.load_side != LoadSide::kModel) return;
  const double torque_per_volt = 1.0 / builder.balance()->unit_per_Nm();
  const std::size_t dead = builder.add("dead time", [balance = builder.balance(), torque_per_volt](
                                                        const Signals& signals, std::size_t i) {
    const double needed = balance->driven_Nm(signals, i);
    return -torque_per_volt * (needed > 0.0 ? 1.0 : -1.0);
  });
  builder.variant("inverter_dead_time", {one(dead, 0.0, kInfinity)});
}

}  // namespace torquewright::identification
