// SPDX-License-Identifier: Apache-2.0
// The contract's table, law by law, at points worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/oracles/bench_log/machine.hpp"
#include "tests/oracles/bench_log/plant.hpp"

namespace torquewright::oracles {
namespace {

Machine plain() {
  Machine machine;
  machine.ratio = 10.0;
  machine.torque_constant_Nm_A = 0.2;
  return machine;
}

TEST(MotorTorque, SaturatesAsTheTableSays) {
  Machine machine = plain();
  machine.saturation_current_A = 20.0;
  machine.saturation_exponent = 2.0;
  // i = i_s with p = 2: divided by sqrt 2. Far beyond: N Kt i_s.
  EXPECT_NEAR(motor_torque_Nm(machine, 20.0, 298.15), 40.0 / std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR(motor_torque_Nm(machine, -2e7, 298.15), -40.0, 1e-9);
}

TEST(MotorTorque, FollowsTemperatureAndFactor) {
  Machine machine = plain();
  machine.torque_constant_1_K = -0.001;
  machine.torque_constant_factor = 1.1;
  EXPECT_NEAR(motor_torque_Nm(machine, 5.0, 348.15), 10.0 * 1.1 * 0.95, 1e-12);
}

TEST(FrictionLaw, IsTheTablesForEachTerm) {
  Machine machine = plain();
  Friction& law = machine.friction;
  law.coulomb_positive_Nm = 0.5;
  law.coulomb_negative_Nm = 0.3;
  law.viscous_positive_Nm_s_rad = 0.1;
  law.viscous_negative_Nm_s_rad = 0.2;
  law.drag_Nm_s2_rad2 = 0.05;
  EXPECT_NEAR(friction_Nm(machine, {0.0, 2.0, 298.15, 0.0, 1e9}, 1.0), 0.5 + 0.2 + 0.2, 1e-15);
  EXPECT_NEAR(friction_Nm(machine, {0.0, -2.0, 298.15, 0.0, 1e9}, -1.0), 0.3 + 0.4 + 0.2, 1e-15);
  law.breakaway_excess_Nm = 0.4;
  law.stribeck_velocity_rad_s = 2.0;
  EXPECT_NEAR(friction_Nm(machine, {0.0, 2.0, 298.15, 0.0, 1e9}, 1.0), 0.9 + 0.4 * std::exp(-1.0),
              1e-15);
  law.breakaway_excess_Nm = 0.0;
  law.coefficient_1_K = -0.004;
  EXPECT_NEAR(friction_Nm(machine, {0.0, 2.0, 323.15, 0.0, 1e9}, 1.0), 0.9 * 0.9, 1e-15);
}

TEST(FrictionLaw, VariesOverThePosition) {
  Machine machine = plain();
  machine.friction.coulomb_positive_Nm = 0.5;
  machine.friction.over_position.terms = {{3.0, 0.2, 0.1}};
  EXPECT_NEAR(friction_Nm(machine, {0.7, 1.0, 298.15, 0.0, 1e9}, 1.0),
              0.5 + 0.2 * std::sin(3.0 * 0.7 + 0.1), 1e-15);
}

TEST(Ripple, StandsOverTheAngleThatTheTableNames) {
  Machine machine = plain();
  machine.cogging.terms = {{4.0, 0.3, 0.2}};
  machine.ripple.terms = {{5.0, 0.1, 0.4}};
  machine.load_ripple.terms = {{6.0, 0.02, 0.6}};
  RunPlan plan;
  plan.speed_rad_s = constant(100, 1.0);
  plan.current_A = constant(100, 10.0);
  const Trace trace = simulate(machine, plan);
  const double q = trace.position_rad.back();
  const double carried = 20.0 + 0.3 * std::sin(4.0 * 10.0 * q + 0.2);
  EXPECT_NEAR(trace.torque_Nm.back(),
              carried * (1.0 + 0.02 * std::sin(6.0 * q + 0.6)) + 0.1 * std::sin(5.0 * q + 0.4),
              1e-12);
}

TEST(Inertia, IsTheRotorsAndWhatIsBeyondIt) {
  Machine machine = plain();
  machine.rotor_inertia_kg_m2 = 3e-4;
  machine.extra_inertia_kg_m2 = 0.02;
  RunPlan plan;
  plan.speed_rad_s = Knots(101);
  for (std::size_t k = 0; k <= 100; ++k)
    plan.speed_rad_s[k] = 7.0 * kTick_s * static_cast<double>(k);
  plan.current_A = constant(101, 0.0);
  EXPECT_NEAR(simulate(machine, plan).torque_Nm[50], -(0.03 + 0.02) * 7.0, 1e-10);
}

TEST(WindingVoltage, BalancesPower) {
  // Power in = copper loss + what the back-EMF takes = torque times speed, before the gear.
  const Machine machine = plain();
  const double voltage = winding_voltage_V(machine, 8.0, 30.0, 298.15);
  const double motor_W = motor_torque_Nm(machine, 8.0, 298.15) / machine.ratio * 30.0;
  EXPECT_NEAR(voltage * 8.0, machine.resistance_ohm * 64.0 + motor_W, 1e-12);
}

TEST(WindingVoltage, HoldsCopperAndDeadTime) {
  Machine machine = plain();
  EXPECT_NEAR(winding_voltage_V(machine, 10.0, 0.0, 318.15), 3.0 * (1.0 + 0.0039 * 20.0), 1e-12);
  machine.dead_time_V = 0.4;
  EXPECT_NEAR(winding_voltage_V(machine, -10.0, 0.0, 298.15), -3.4, 1e-12);
  EXPECT_EQ(current_from_voltage_A(machine, 0.3, 0.0, 298.15), 0.0);
  EXPECT_NEAR(current_from_voltage_A(machine, -3.4, 0.0, 298.15), -10.0, 1e-12);
}

TEST(BusVoltage, FallsByDutyTimesCurrentTimesResistance) {
  Machine machine = plain();
  machine.sag_ohm = 0.1;
  for (const double current : {12.0, -12.0}) {
    const double bus = bus_voltage_V(machine, 20.0, current);
    const double duty = 20.0 / bus;
    EXPECT_NEAR(machine.bus_V - bus, 0.1 * duty * current, 1e-12);
  }
}

}  // namespace
}  // namespace torquewright::oracles
