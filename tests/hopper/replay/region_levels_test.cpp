// SPDX-License-Identifier: Apache-2.0
// Oracle: the region itself (actuator/region), asked at that voltage and temperature alone.
#include "hopper/replay/region_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "actuator/motor/actuator_spec.hpp"
#include "actuator/region/joint_region.hpp"
#include "tests/hopper/replay/driven_robot.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;

actuator::JointRange exactly(Actuator actuator, double bus_V, double winding_K,
                             double speed_rad_s) {
  actuator.battery.reset();
  actuator.drive.bus_voltage_V = bus_V;
  actuator::OperatingConditions conditions;
  conditions.winding_temperature_K = winding_K;
  return actuator::Region(actuator, conditions).at(speed_rad_s);
}

/// The same laws as a document may state them, at round numbers.
std::vector<Actuator> actuators() {
  std::vector<Actuator> all{round_drive(0.1)};
  all.push_back(all[0]);
  all[1].effects = {actuator::effect("torque_constant_saturation", {60.0, 2.0}),
                    actuator::effect("coulomb_friction", {4.0}),
                    actuator::effect("viscous_friction", {0.5}),
                    actuator::effect("load_dependent_friction", {0.05, 0.05})};
  all.push_back(all[1]);
  all[2].motor.inductance_d_H = all[2].motor.inductance_q_H = 2e-4;
  all[2].motor.pole_pairs = 10.0;
  all[2].drive.field_weakening = true;
  return all;
}

// What a table may be off, and a corner of the bound over the voltage: a quarter of a level, 0.2 V,
// times the steepest that a bound rises with the voltage, N Kt / R = 10 Nm/V.
TEST(RegionLevels, AreTheRegionToAQuarterOfALevel) {
  constexpr double kFewTimes = 4.0;  // the table's own accuracy is that at three points of a row
  for (const Actuator& actuator : actuators()) {
    const RegionLevels levels(actuator, actuator::Rating::kPeak);
    for (const double bus_V : {30.0, 47.05, 49.9, 50.0, 50.13, 55.0}) {
      for (const double winding_K : {298.15, 331.0}) {
        for (double speed_rad_s = -9.0; speed_rad_s <= 9.0; speed_rad_s += 0.7) {
          const actuator::JointRange range = exactly(actuator, bus_V, winding_K, speed_rad_s);
          if (range.is_empty) continue;
          const actuator::Interval limits = levels.limits(bus_V, winding_K, speed_rad_s);
          const double off_Nm = kFewTimes * actuator::kTableAccuracy * 200.0 + 0.25 * 0.2 * 10.0;
          EXPECT_NEAR(limits.greatest_Nm, range.greatest.torque_Nm, off_Nm)
              << bus_V << " V, " << winding_K << " K, " << speed_rad_s << " rad/s";
          EXPECT_NEAR(limits.least_Nm, range.least.torque_Nm, off_Nm);
        }
      }
    }
  }
}

TEST(RegionLevels, HoldNoTorqueWithoutVoltageAndTheLastBeyondTheLast) {
  const RegionLevels levels(round_drive(0.1), actuator::Rating::kPeak);
  for (const double bus_V : {0.0, -5.0}) {
    EXPECT_EQ(levels.limits(bus_V, 300.0, 1.0).greatest_Nm, 0.0);
    EXPECT_EQ(levels.limits(bus_V, 300.0, 1.0).least_Nm, 0.0);
  }
  EXPECT_EQ(levels.limits(1e9, 300.0, 15.0).greatest_Nm,
            levels.limits(100.0, 300.0, 15.0).greatest_Nm);
  EXPECT_EQ(levels.limits(50.0, 1e9, 8.0).greatest_Nm, levels.limits(50.0, 900.0, 8.0).greatest_Nm);
  EXPECT_EQ(levels.limits(50.0, 0.0, 8.0).greatest_Nm, levels.limits(50.0, 150.0, 8.0).greatest_Nm);
  // Halfway to the first level of 0.2 V: half of its 4 A.
  EXPECT_NEAR(levels.limits(0.1, 298.15, 0.0).greatest_Nm, 1.0, 1e-3);
}

// Oracle: phase_model_at, which knows the laws of the temperature. They are linear.
TEST(RegionLevels, ModelsFollowTheTemperature) {
  const Actuator actuator = round_drive(0.0);
  const RegionLevels levels(actuator, actuator::Rating::kPeak);
  for (const double winding_K : {298.15, 300.0, 287.3, 411.9}) {
    actuator::OperatingConditions conditions;
    conditions.winding_temperature_K = winding_K;
    const actuator::PhaseModel exact = phase_model_at(actuator, conditions);
    const actuator::PhaseModel model = levels.model(33.0, winding_K);
    EXPECT_NEAR(model.resistance_ohm, exact.resistance_ohm, 1e-14);
    EXPECT_NEAR(model.torque_constant_Nm_A, exact.torque_constant_Nm_A, 1e-14);
    EXPECT_NEAR(model.back_emf_V_s_rad, exact.back_emf_V_s_rad, 1e-14);
    EXPECT_EQ(model.supply.open_circuit_V, 33.0);
    EXPECT_EQ(model.supply.resistance_ohm, 0.0);
  }
}

// Whatever moves a bound makes another actuator of it; what does not, does not.
TEST(RegionLevels, AreOfEveryActuatorWithTheSameRegion) {
  const Actuator own = actuators()[1];
  const RegionLevels levels(own, actuator::Rating::kPeak);
  const auto are_of = [&](auto change) {
    Actuator other = own;
    change(other);
    return levels.are_of(other, actuator::Rating::kPeak);
  };
  EXPECT_TRUE(are_of([](Actuator&) {}));
  EXPECT_TRUE(are_of([](Actuator& other) { other.name = "another"; }));
  EXPECT_TRUE(are_of([](Actuator& other) { other.battery->cell_resistance_ohm = 1.0; }));
  EXPECT_FALSE(are_of([](Actuator& other) { other.battery->series_cells = 2.0; }));
  EXPECT_FALSE(are_of([](Actuator& other) { other.motor.torque_constant_Nm_A = 0.4; }));
  EXPECT_FALSE(are_of([](Actuator& other) { other.drive.peak_current_A = 41.0; }));
  EXPECT_FALSE(are_of([](Actuator& other) { other.transmission.ratio = 11.0; }));
  EXPECT_FALSE(are_of([](Actuator& other) { other.effects[1].values[0] = 4.1; }));
  EXPECT_FALSE(are_of([](Actuator& other) { other.effects.pop_back(); }));
  EXPECT_FALSE(are_of([](Actuator& other) {
    other.thermal = actuator::Thermal{0.5, 1.0, 20.0, 100.0, 400.0};
  }));
  EXPECT_FALSE(levels.are_of(own, actuator::Rating::kContinuous));
}

}  // namespace
}  // namespace torquewright::hopper
