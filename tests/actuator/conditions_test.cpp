// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/region/motor_region.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

// Oracle: copper's 0.0039 1/K, unless an effect says otherwise.
TEST(OperatingConditions, WarmTheWinding) {
  Actuator actuator = round_actuator();
  OperatingConditions warm;
  warm.winding_temperature_K = 398.15;
  EXPECT_NEAR(phase_model_at(actuator, warm).resistance_ohm, 0.25 * 1.39, 1e-15);
  actuator.effects.push_back(effect("winding_resistance_temperature", {0.005}));
  EXPECT_NEAR(phase_model_at(actuator, warm).resistance_ohm, 0.25 * 1.5, 1e-15);
}

TEST(OperatingConditions, WeakenMagnetsInTorqueAndBackEmf) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("torque_constant_temperature", {-0.001}));
  OperatingConditions warm;
  warm.winding_temperature_K = 398.15;
  const PhaseModel cold = phase_model_at(actuator, {});
  const PhaseModel hot = phase_model_at(actuator, warm);
  EXPECT_NEAR(hot.torque_constant_Nm_A / cold.torque_constant_Nm_A, 0.9, 1e-14);
  EXPECT_NEAR(hot.back_emf_V_s_rad / cold.back_emf_V_s_rad, 0.9, 1e-14);
}

// Oracle: in the long run the winding stands at ambient + P (R_wc + R_ca), with its hot resistance.
TEST(SteadyCurrent, WarmsTheWindingToItsLimit) {
  Actuator actuator = round_actuator();
  actuator.thermal = Thermal{1.0, 2.0, 50.0, 500.0, 398.15, 298.15};
  const double current_A = *steady_current_A(actuator);
  const double hot_ohm = 0.5 * (1.0 + 0.0039 * 100.0);
  EXPECT_NEAR(current_A * current_A * hot_ohm * 3.0, 100.0, 1e-10);
}

TEST(OperatingConditions, TakeTheLowerOfStatedAndThermalCurrent) {
  Actuator actuator = round_actuator();
  OperatingConditions continuous;
  continuous.rating = Rating::kContinuous;
  EXPECT_EQ(objections(actuator, continuous).size(), 1u);
  actuator.thermal = Thermal{1.0, 2.0, 50.0, 500.0, 398.15, 298.15};
  EXPECT_TRUE(objections(actuator, continuous).empty());
  EXPECT_EQ(motor_range(phase_model_at(actuator, continuous), 0.0).greatest.limiter,
            Limiter::kThermal);
  actuator.drive.continuous_current_A = 1.0;
  const MotorRange range = motor_range(phase_model_at(actuator, continuous), 0.0);
  EXPECT_NEAR(range.greatest.torque_Nm, 0.5, 1e-14);
  EXPECT_EQ(range.greatest.limiter, Limiter::kCurrent);
}

TEST(OperatingConditions, ReadTheBatterysCurve) {
  Actuator actuator = round_actuator();
  OperatingConditions half;
  half.state_of_charge = 0.5;
  EXPECT_EQ(objections(actuator, half).size(), 1u);  // no battery
  actuator.battery = Battery{};
  actuator.battery->series_cells = 16.0;
  actuator.battery->cell_open_circuit = {{0.0, 3.0}, {0.4, 3.6}, {1.0, 4.2}};
  EXPECT_TRUE(objections(actuator, half).empty());
  EXPECT_NEAR(open_circuit_voltage_V(actuator, half), 16.0 * 3.7, 1e-12);
  EXPECT_NEAR(open_circuit_voltage_V(actuator, {}), 67.2, 1e-12);
  half.bus_voltage_V = 48.0;
  EXPECT_EQ(objections(actuator, half).size(), 1u);  // both asked for
}

// Oracle: Kirchhoff. Cells in series over cells in parallel, cable and voltage_sag in series.
TEST(OperatingConditions, AddUpTheSuppliesResistance) {
  Actuator actuator = round_actuator();
  actuator.battery = Battery{};
  actuator.battery->series_cells = 16.0;
  actuator.battery->parallel_cells = 4.0;
  actuator.battery->cell_open_circuit = {{1.0, 4.2}};
  actuator.battery->cell_resistance_ohm = 0.015;
  actuator.battery->wiring_resistance_ohm = 0.02;
  actuator.effects.push_back(effect("voltage_sag", {0.01}));
  EXPECT_NEAR(phase_model_at(actuator, {}).supply.resistance_ohm, 0.06 + 0.02 + 0.01, 1e-15);
}

// Oracle: V^2 - Voc V + R P = 0.
TEST(BusVoltage, SolvesTheQuadratic) {
  const Supply supply{67.2, 0.06, kUnlimited, -kUnlimited};
  for (const double power_W : {-3000.0, 0.0, 3000.0, 6000.0, 18000.0}) {
    const double bus_V = *bus_voltage_V(supply, power_W);
    EXPECT_NEAR(bus_V * bus_V - 67.2 * bus_V + 0.06 * power_W, 0.0, 1e-10);
    EXPECT_GE(bus_V, 33.6);
  }
  EXPECT_FALSE(bus_voltage_V(supply, 67.2 * 67.2 / 0.24 + 1e-6));
}

TEST(OperatingConditions, RefuseASelfLockingGearWithoutItsStrength) {
  Actuator actuator = round_actuator();
  actuator.transmission.backward_efficiency = 0.0;
  EXPECT_EQ(objections(actuator, {}).size(), 1u);
  actuator.transmission.peak_torque_Nm = 500.0;
  EXPECT_TRUE(objections(actuator, {}).empty());
}

}  // namespace
}  // namespace torquewright::actuator
