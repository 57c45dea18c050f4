// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/operating_conditions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "actuator/effects/library.hpp"
#include "actuator/region/motor_region.hpp"
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

// A gearbox that holds a thousand times what the motor gives holds by its teeth, whether it is its
// efficiency that says so or friction by the load.
TEST(OperatingConditions, AskWhatTeethHoldWhereAGearboxLocks) {
  for (const double efficiency : {0.0, 5e-324, 1e-12, 0.9e-3}) {
    Actuator actuator = round_actuator();
    actuator.transmission.backward_efficiency = efficiency;
    EXPECT_EQ(objections(actuator, {}).size(), 1u) << efficiency;
    actuator.transmission.peak_torque_Nm = 100.0;
    EXPECT_TRUE(objections(actuator, {}).empty()) << efficiency;
  }
  Actuator actuator = round_actuator();
  actuator.transmission.backward_efficiency = 1.1e-3;
  EXPECT_TRUE(objections(actuator, {}).empty());
  actuator.effects = {{find_effect("load_dependent_friction"), {0.0, 0.5}, {}, false, "stated"}};
  EXPECT_EQ(objections(actuator, {}).size(), 1u);
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
  // A curve says nothing beyond its ends; its own ends it does.
  actuator.battery->cell_open_circuit = {{0.5, 3.7}, {0.9, 4.1}};
  for (const auto& [charge, faults] : {std::pair{0.49, 1u}, {0.5, 0u}, {0.9, 0u}, {0.91, 1u}}) {
    half.state_of_charge = charge;
    EXPECT_EQ(objections(actuator, half).size(), faults) << charge;
  }
  EXPECT_TRUE(objections(actuator, {}).empty());
  half.state_of_charge = 0.5;
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

/// The round actuator's winding in amperes of another convention: the same copper, the same
/// magnets. `phase_A` amplitudes of a phase are one of its amperes.
Actuator round_actuator_in(CurrentConvention convention, double phase_A) {
  const double dc_A = 2.0 / std::sqrt(3.0);
  Actuator actuator = round_actuator();
  actuator.motor.torque_constant_convention = convention;
  actuator.motor.torque_constant_Nm_A *= phase_A / dc_A;
  actuator.motor.demagnetisation_current_A = 12.0 * dc_A / phase_A;
  actuator.motor.inductance_d_H = actuator.motor.inductance_q_H = 2e-4;
  actuator.motor.pole_pairs = 10.0;
  actuator.drive.peak_current_A *= dc_A / phase_A;
  actuator.drive.field_weakening = true;
  return actuator;
}

// Oracle: by its definition an ampere of `dc` is 2/sqrt(3) of a phase's amplitude, one of
// `rms_phase` sqrt(2), so that a motor stated three ways is the same motor: its magnets stand the
// same 12 dc amperes of d current, and the region that they limit is the same.
TEST(OperatingConditions, CountEveryCurrentInTheDocumentsConvention) {
  const double dc_A = 2.0 / std::sqrt(3.0);
  const PhaseModel by_dc = phase_model_at(round_actuator_in(CurrentConvention::kDc, dc_A), {});
  EXPECT_NEAR(by_dc.demagnetisation_current_A, 12.0 * dc_A, 1e-12);
  const MotorRange weakened = motor_range(by_dc, 110.0);
  ASSERT_EQ(weakened.greatest.limiter, Limiter::kDemagnetisation);
  for (const auto& [convention, phase_A] :
       {std::pair{CurrentConvention::kPeakPhase, 1.0},
        std::pair{CurrentConvention::kRmsPhase, std::sqrt(2.0)}}) {
    const PhaseModel model = phase_model_at(round_actuator_in(convention, phase_A), {});
    EXPECT_NEAR(model.current_limit_A, by_dc.current_limit_A, 1e-12);
    EXPECT_NEAR(model.demagnetisation_current_A, by_dc.demagnetisation_current_A, 1e-12);
    EXPECT_NEAR(motor_range(model, 110.0).greatest.torque_Nm, weakened.greatest.torque_Nm, 1e-9);
  }
}

/// 50 V behind 0.1 ohm.
Actuator round_actuator_on_a_battery() {
  Actuator actuator = round_actuator();
  actuator.battery = Battery{};
  actuator.battery->cell_open_circuit = {{1.0, 50.0}};
  actuator.battery->cell_resistance_ohm = 0.1;
  return actuator;
}

/// Torque at which K w i + R i^2 is that power: the root that is nearer to zero.
double torque_of_power_Nm(double power_W, double speed_rad_s) {
  const double back_emf_V = 0.5 * speed_rad_s;
  return 0.5 * (-back_emf_V + std::sqrt(back_emf_V * back_emf_V + 4.0 * 0.5 * power_W)) /
         (2.0 * 0.5);
}

// Oracle: Kirchhoff. 8 A into 50 V behind 0.1 ohm: the bus stands at 50.8 V and gives 406.4 W; the
// motor brakes with the torque whose power that is.
TEST(OperatingConditions, ReturnNoMoreThanTheChargeLimit) {
  Actuator actuator = round_actuator_on_a_battery();
  actuator.battery->charge_limit_A = 8.0;
  const PhaseModel model = phase_model_at(actuator, {});
  EXPECT_NEAR(model.supply.least_power_W, -8.0 * 50.8, 1e-12);
  const MotorRange range = motor_range(model, 90.0);
  EXPECT_EQ(range.least.limiter, Limiter::kRegeneration);
  EXPECT_NEAR(range.least.torque_Nm, torque_of_power_Nm(-406.4, 90.0), 1e-9);
}

// Oracle: Kirchhoff. Between 50 V open and 52 V allowed, 2 V over 0.1 ohm are 20 A: 1040 W at the
// bus. A pack that stands at its limit, or above it, takes nothing.
TEST(OperatingConditions, KeepTheBusBelowTheBatterysGreatestVoltage) {
  Actuator actuator = round_actuator_on_a_battery();
  actuator.battery->maximum_voltage_V = 52.0;
  const PhaseModel model = phase_model_at(actuator, {});
  EXPECT_NEAR(model.supply.least_power_W, -20.0 * 52.0, 1e-10);
  const MotorRange range = motor_range(model, 100.0);
  EXPECT_NEAR(range.least.torque_Nm, torque_of_power_Nm(-1040.0, 100.0), 1e-9);
  EXPECT_NEAR(*bus_voltage_V(model.supply, range.least.bus_power_W), 52.0, 1e-9);
  for (const double limit_V : {50.0, 49.0}) {
    actuator.battery->maximum_voltage_V = limit_V;
    EXPECT_EQ(phase_model_at(actuator, {}).supply.least_power_W, 0.0) << limit_V;
  }
}

// The tightest of the drive's and the battery's two limits holds: 300 W, 406.4 W, 1040 W.
TEST(OperatingConditions, ReturnWhatTheTightestLimitAllows) {
  Actuator actuator = round_actuator_on_a_battery();
  const auto least_W = [&] { return phase_model_at(actuator, {}).supply.least_power_W; };
  actuator.battery->maximum_voltage_V = 52.0;
  actuator.battery->charge_limit_A = 8.0;
  EXPECT_NEAR(least_W(), -406.4, 1e-12);
  actuator.battery->charge_limit_A = 30.0;
  EXPECT_NEAR(least_W(), -1040.0, 1e-10);
  actuator.drive.regeneration_limit_W = 300.0;
  EXPECT_EQ(least_W(), -300.0);
  actuator.drive.regeneration = false;
  EXPECT_EQ(least_W(), 0.0);
}

// Oracle: the law by hand at the current limit, T = K i (1 + (i/i_s)^p)^(-1/p), for exponents other
// than the usual 2 and a current of saturation in the document's amperes.
TEST(OperatingConditions, SaturateWithTheDocumentsCurrentAndExponent) {
  for (const double exponent : {1.0, 3.0}) {
    Actuator actuator = round_actuator();
    actuator.effects.push_back(effect("torque_constant_saturation", {30.0, exponent}));
    const double by_hand_Nm =
        0.5 * 40.0 / std::pow(1.0 + std::pow(40.0 / 30.0, exponent), 1.0 / exponent);
    EXPECT_NEAR(motor_range(phase_model_at(actuator, {}), 0.0).greatest.torque_Nm, by_hand_Nm,
                1e-12);
  }
}

// Oracle: one flux makes torque and back-EMF, so that a motor which yields 1.25 of the stated
// torque per ampere runs at 1/1.25 of the speed without load: 100 rad/s become 80. A back-EMF
// constant that was stated itself stays.
TEST(OperatingConditions, GiveAWrongTorqueConstantToTheBackEmfToo) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("torque_constant_error", {1.25}));
  const PhaseModel model = phase_model_at(actuator, {});
  EXPECT_NEAR(no_load_speed_rad_s(model), 80.0, 1e-12);
  EXPECT_NEAR(motor_range(model, 0.0).greatest.torque_Nm, 25.0, 1e-12);
  EXPECT_NEAR(1.5 * model.back_emf_V_s_rad, model.torque_constant_Nm_A, 1e-15);
  actuator.motor.back_emf_constant_V_s_rad = 0.4;
  EXPECT_NEAR(no_load_speed_rad_s(phase_model_at(actuator, {})), 125.0, 1e-12);
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
