// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/bus_levels.hpp"

#include <gtest/gtest.h>

#include "tests/actuator/check/simple_actuator.hpp"

namespace torquewright::actuator {
namespace {

double bus_V(const CheckBasis& basis) {
  return basis.lookup.region().model().supply.open_circuit_V;
}

// Oracle: by hand. A level is 48 mV: 40 V lie between the 833rd, 39.984 V, and the next; 2.304 V
// are the 48th, though 2.304 / 0.048 rounds to less; below the first there is none.
TEST(BusLevels, HoldTheVoltageNextBelow) {
  const Actuator actuator = test::simple_actuator();
  BusLevels levels(actuator, {});
  EXPECT_NEAR(bus_V(levels.at(40.0)), 39.984, 1e-12);
  EXPECT_NEAR(bus_V(levels.at(2.304)), 2.304, 1e-12);
  EXPECT_NEAR(bus_V(levels.at(0.01)), 0.048, 1e-12);
  EXPECT_EQ(&levels.at(40.0), &levels.at(40.031));
  EXPECT_NE(&levels.at(40.0), &levels.at(40.033));
}

// The bus is held: what the battery's own resistance takes at that voltage is taken already. A
// level is a thousandth of its open circuit, 12 * 4 V.
TEST(BusLevels, AreStiff) {
  Actuator actuator = test::simple_actuator();
  actuator.drive.bus_voltage_V = 20.0;
  Battery& battery = actuator.battery.emplace();
  battery.series_cells = 12;
  battery.cell_open_circuit = {{1.0, 4.0}};
  battery.cell_resistance_ohm = 0.015;
  BusLevels levels(actuator, {});
  const CheckBasis& basis = levels.at(40.0);
  EXPECT_NEAR(bus_V(basis), 39.984, 1e-12);
  EXPECT_EQ(basis.lookup.region().model().supply.resistance_ohm, 0.0);
}

}  // namespace
}  // namespace torquewright::actuator
