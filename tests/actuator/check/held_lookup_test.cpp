// SPDX-License-Identifier: Apache-2.0
// Oracle: the region itself, with the bus held at each voltage.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "actuator/drive_check/region_lookup.hpp"
#include "tests/actuator/check/simple_actuator.hpp"
#include "tests/actuator/random_actuator.hpp"

namespace torquewright::actuator {
namespace {

RegionLookup lookup_at(const Actuator& actuator, double bus_V) {
  const auto held = std::make_shared<const HeldRegion>(actuator, OperatingConditions{},
                                                       GridTemperatures::kAsAsked);
  return {held, bus_V, actuator.motor.winding_temperature_K};
}

// The bus is held: what the battery's own resistance takes at that voltage is taken already.
TEST(HeldLookup, IsStiff) {
  Actuator actuator = test::simple_actuator();
  actuator.drive.bus_voltage_V = 20.0;
  Battery& battery = actuator.battery.emplace();
  battery.series_cells = 12;
  battery.cell_open_circuit = {{1.0, 4.0}};
  battery.cell_resistance_ohm = 0.015;
  const RegionLookup lookup = lookup_at(actuator, 40.0);
  EXPECT_EQ(lookup.model().supply.open_circuit_V, 40.0);
  EXPECT_EQ(lookup.model().supply.resistance_ohm, 0.0);
}

// Whether inside or outside is exact at any voltage, of drives with every kind of jump and corner;
// half of the torques lie within 1e-3 of a bound.
TEST(HeldLookup, JudgesAsTheRegionItselfDoes) {
  std::mt19937 dice(5);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int outside = 0;
  int judged = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    Actuator actuator = random_actuator(seed, {true, seed % 2 == 0, seed % 4 == 0});
    const double open_V = open_circuit_voltage_V(actuator, {});
    const auto held = std::make_shared<const HeldRegion>(actuator, OperatingConditions{},
                                                         GridTemperatures::kAsAsked);
    actuator.battery.reset();
    for (int v = 0; v < 12; ++v) {
      const double bus_V = open_V * (0.85 + 0.4 * share(dice));
      const RegionLookup lookup(held, bus_V, actuator.motor.winding_temperature_K);
      actuator.drive.bus_voltage_V = bus_V;
      const Region region(actuator, {});
      const double end_rad_s = region.greatest_speed_rad_s();
      const double most_Nm = held->peak_torque_Nm();
      for (int i = 0; i < 150; ++i) {
        const double speed_rad_s = i % 15 == 0 ? 0.0 : 1.1 * end_rad_s * share(dice);
        const JointRange range = region.at(speed_rad_s);
        const double bound_Nm = i % 4 < 2 ? range.greatest.torque_Nm : range.least.torque_Nm;
        const double torque_Nm =
            i % 2 == 0 ? 1.2 * most_Nm * share(dice) : bound_Nm * (1.0 + 1e-3 * share(dice));
        const bool truth = range.is_empty ||
                           torque_Nm > range.greatest.torque_Nm + lookup.round_off_Nm() ||
                           torque_Nm < range.least.torque_Nm - lookup.round_off_Nm();
        ASSERT_EQ(lookup.is_outside(lookup.at(speed_rad_s, torque_Nm), torque_Nm), truth)
            << bus_V << " V " << speed_rad_s << " rad/s " << torque_Nm << " Nm";
        outside += truth ? 1 : 0;
        ++judged;
      }
    }
  }
  EXPECT_GT(outside, judged / 5);
  EXPECT_LT(outside, judged * 4 / 5);
}

// Oracle: closed form. With K = N Kt the torque tau is there up to V/K - R tau / K^2: for the
// simple actuator V - tau / 2 rad/s.
TEST(HeldLookup, SpeedMarginIsTheDistanceToTheVoltageLine) {
  for (const double bus_V : {48.0, 41.3, 70.0}) {  // the last beyond the table
    const RegionLookup lookup = lookup_at(test::simple_actuator(), bus_V);
    EXPECT_NEAR(lookup.speed_margin_rad_s(10.0, 20.0), bus_V - 10.0 - 10.0, 1e-6);
    EXPECT_NEAR(lookup.speed_margin_rad_s(-10.0, -20.0), bus_V - 10.0 - 10.0, 1e-6);
  }
}

}  // namespace
}  // namespace torquewright::actuator
