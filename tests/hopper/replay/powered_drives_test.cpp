// SPDX-License-Identifier: Apache-2.0
// Drives of round numbers (driven_robot.hpp) on their battery.
// Oracles: Ohm's law of a motor in series with its battery; the balance of power and Kirchhoff's
// quadratic; the exact solution of the two thermal nodes; what friction may do to a flywheel.
#include "hopper/replay/powered_drives.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "actuator/drive_check/demand.hpp"
#include "actuator/heat/heat_model.hpp"
#include "actuator/mor/mor_table.hpp"
#include "io/faults/spec_error.hpp"
#include "tests/hopper/replay/driven_robot.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kStep_s = 5e-4;
constexpr double kNmPerAmpere = 5.0;  // at the output
constexpr double kWinding_ohm = 0.5;
constexpr double kPeak_Nm = 200.0;
constexpr double kTable_Nm = actuator::kTableAccuracy * kPeak_Nm;
/// The voltage is solved to 1e-7 of 50 V, and a bound moves by 10 Nm/V.
constexpr double kSolved_Nm = 1e-4;

PoweredDrives one_drive(const Actuator& actuator, const PoweredDriveOptions& options = {}) {
  return PoweredDrives(driven_robot({actuator}), options);
}

VectorXd alone(double value) { return VectorXd::Constant(1, value); }

/// What one drive does with a torque at a speed.
DriveStep step_of(PoweredDrives& drives, double wanted_Nm, double speed_rad_s) {
  return drives.drive(alone(wanted_Nm), alone(0.0), alone(speed_rad_s), kStep_s);
}

// Oracle: Ohm's law. Where the voltage limits, motor and battery are one circuit: i = (Voc - 5 w) /
// (R + R_b), and the torque is 5 i. Elsewhere the torque is the one wanted, or that of 40 A.
TEST(PoweredDrives, ObeyOhmsLawOfMotorAndBattery) {
  for (const double battery_ohm : {0.0, 0.05, 0.4}) {
    PoweredDrives drives = one_drive(round_drive(battery_ohm));
    for (double speed_rad_s = -9.9; speed_rad_s < 10.0; speed_rad_s += 0.37) {
      for (const double wanted_Nm : {-1e4, -150.0, -3.0, 0.0, 3.0, 150.0, 1e4}) {
        const auto circuit_A = [&](double sign) {
          return (sign * 50.0 - kNmPerAmpere * speed_rad_s) / (kWinding_ohm + battery_ohm);
        };
        const double greatest_Nm = std::min(kPeak_Nm, kNmPerAmpere * circuit_A(1.0));
        const double least_Nm = std::max(-kPeak_Nm, kNmPerAmpere * circuit_A(-1.0));
        const double acts_Nm = std::clamp(wanted_Nm, least_Nm, greatest_Nm);
        const DriveStep step = step_of(drives, wanted_Nm, speed_rad_s);
        // Near the corner of current and voltage: a quarter of a level of 0.2 V times 10 Nm/V.
        const double corner_Nm =
            std::abs(std::abs(acts_Nm) - kPeak_Nm) < 0.2 * 10.0 + kTable_Nm ? 0.5 : 0.0;
        EXPECT_NEAR(step.torque_Nm[0], acts_Nm, kTable_Nm + kSolved_Nm + corner_Nm)
            << battery_ohm << " ohm, " << speed_rad_s << " rad/s, " << wanted_Nm << " Nm";
        EXPECT_EQ(step.cut_off_Nm[0], wanted_Nm - step.torque_Nm[0]);
        EXPECT_FALSE(step.is_starved);
      }
    }
  }
}

// Oracles: conservation of energy, and Kirchhoff. What leaves the batteries is what shafts and
// windings take, and V^2 - Voc V + R P = 0.
TEST(PoweredDrives, BalanceTheirPower) {
  constexpr double kBattery_ohm = 0.1;
  Actuator other = round_drive(kBattery_ohm);
  other.transmission.ratio = -10.0;
  PoweredDrives drives(driven_robot({round_drive(kBattery_ohm), other}), {});
  std::mt19937 dice(7);
  std::uniform_real_distribution<double> torque(-300.0, 300.0);
  std::uniform_real_distribution<double> speed(-11.0, 11.0);
  int clipped = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector2d wanted_Nm(torque(dice), torque(dice));
    const Vector2d speed_rad_s(speed(dice), speed(dice));
    const DriveStep step = drives.drive(wanted_Nm, Vector2d::Zero(), speed_rad_s, kStep_s);
    double power_W = 0.0;
    for (Index k = 0; k < 2; ++k) {
      const double current_A = std::abs(step.torque_Nm[k]) / kNmPerAmpere;
      EXPECT_NEAR(step.current_A[k], current_A, 1e-12 * 60.0);
      power_W += step.torque_Nm[k] * speed_rad_s[k] + kWinding_ohm * current_A * current_A;
      if (step.cut_off_Nm[k] != 0.0) ++clipped;
    }
    EXPECT_NEAR(step.power_W, power_W, 1e-12 * 1e4);
    const double bus_V = step.bus_V[0];
    EXPECT_EQ(step.bus_V[1], bus_V);
    EXPECT_NEAR(bus_V * bus_V - 50.0 * bus_V + kBattery_ohm * power_W, 0.0, 1e-12 * 1e4);
    // The bounds were those of this voltage: |v| <= V for whoever was clipped by it.
    for (Index k = 0; k < 2; ++k) {
      const double phase_V =
          std::abs(step.torque_Nm[k] / kNmPerAmpere * kWinding_ohm + 5.0 * speed_rad_s[k]);
      if (std::abs(speed_rad_s[k]) < 9.0) {
        EXPECT_LT(phase_V, bus_V + 0.1 * (kTable_Nm + kSolved_Nm));
      }
    }
  }
  EXPECT_GT(clipped, 500);
}

// Oracle: Kirchhoff's quadratic. 50 Nm at 4 rad/s take 200 W and 10 A in half an ohm, 250 W, of a
// battery of 50 V behind 0.4 ohm; what is asked for beforehand is no part of a run.
TEST(PoweredDrives, CountTheChargeThatLeavesTheBattery) {
  constexpr double kPower_W = 250.0, kBattery_ohm = 0.4;
  constexpr int kSteps = 1000;
  const double current_A =
      (50.0 - std::sqrt(50.0 * 50.0 - 4.0 * kBattery_ohm * kPower_W)) / (2.0 * kBattery_ohm);
  PoweredDrives drives = one_drive(round_drive(kBattery_ohm));
  step_of(drives, 50.0, 4.0);
  drives.start();
  for (int i = 0; i < kSteps; ++i) step_of(drives, 50.0, 4.0);
  ASSERT_EQ(drives.drawn_Ah().size(), 1u);
  EXPECT_NEAR(drives.drawn_Ah()[0], current_A * kSteps * kStep_s / 3600.0, 1e-12);
}

// Oracle: a supply without resistance has one voltage.
TEST(PoweredDrives, OfAStiffSupplyKeepTheirVoltageAndRegion) {
  PoweredDrives drives = one_drive(actuator::round_actuator());
  for (const double wanted_Nm : {-500.0, -20.0, 20.0, 500.0}) {
    for (const double speed_rad_s : {-5.0, 0.0, 3.0, 8.0}) {
      const DriveStep step = step_of(drives, wanted_Nm, speed_rad_s);
      EXPECT_EQ(step.bus_V[0], 50.0);
      const double greatest_Nm = std::min(kPeak_Nm, 500.0 - 50.0 * speed_rad_s);
      const double least_Nm = std::max(-kPeak_Nm, -500.0 - 50.0 * speed_rad_s);
      EXPECT_NEAR(step.torque_Nm[0], std::clamp(wanted_Nm, least_Nm, greatest_Nm), kTable_Nm);
    }
  }
}

// Oracle: demand_at, which `hopper check` asks, at the voltage that is left: current and power of
// the torque that acts, where both hang on the voltage because the field is weakened for it.
TEST(PoweredDrives, TakeWhatTheCheckSaysATorqueTakes) {
  Actuator actuator = round_drive(0.1);
  actuator.motor.inductance_d_H = actuator.motor.inductance_q_H = 5e-4;
  actuator.motor.pole_pairs = 10.0;
  actuator.drive.field_weakening = true;
  actuator.effects = {actuator::effect("torque_constant_saturation", {60.0, 2.0}),
                      actuator::effect("coulomb_friction", {3.0}),
                      actuator::effect("load_dependent_friction", {0.1, 0.1})};
  PoweredDrives drives(driven_robot({actuator, actuator}), {});
  Actuator held = actuator;
  held.battery.reset();
  std::mt19937 dice(5);
  std::uniform_real_distribution<double> torque(-150.0, 150.0);
  std::uniform_real_distribution<double> speed(-14.0, 14.0);
  int weakened = 0;
  for (int i = 0; i < 500; ++i) {
    const Vector2d speed_rad_s(speed(dice), 0.3 * speed(dice));
    const Vector2d wanted_Nm(torque(dice), torque(dice));
    const DriveStep step = drives.drive(wanted_Nm, Vector2d::Zero(), speed_rad_s, kStep_s);
    held.drive.bus_voltage_V = step.bus_V[0];
    const actuator::PhaseModel model = phase_model_at(held, {});
    double power_W = 0.0;
    for (Index k = 0; k < 2; ++k) {
      const auto demand = demand_at(held, model, actuator::kDefaultTemperature_K, speed_rad_s[k],
                                    step.torque_Nm[k]);
      ASSERT_TRUE(demand);
      power_W += demand->bus_power_W;
      // 1e-7 of 50 V moves a current that weakens the field by some 100 A/V at most.
      EXPECT_NEAR(step.current_A[k], demand->current_A, 1e-3) << i;
      const double torque_A = std::abs(demand->motor_torque_Nm) / 0.5;
      if (demand->current_A > 1.3 * torque_A + 1.0) ++weakened;
    }
    EXPECT_NEAR(step.power_W, power_W, 1e-2) << i;
  }
  EXPECT_GT(weakened, 50);
}

// Oracle: the document's law. A drive that knows its friction makes up for it: the torque acts as
// wanted, and the current is that of torque and friction.
TEST(PoweredDrives, MakeUpForTheFrictionTheyKnow) {
  Actuator actuator = actuator::round_actuator();
  actuator.effects = {actuator::effect("coulomb_friction", {10.0})};
  PoweredDrives drives = one_drive(actuator);
  EXPECT_DOUBLE_EQ(step_of(drives, 50.0, 2.0).torque_Nm[0], 50.0);
  EXPECT_NEAR(step_of(drives, 50.0, 2.0).current_A[0], 60.0 / kNmPerAmpere, 1e-12);
  EXPECT_NEAR(step_of(drives, 50.0, -2.0).current_A[0], 40.0 / kNmPerAmpere, 1e-12);
  EXPECT_NEAR(step_of(drives, 1e3, 2.0).torque_Nm[0], kPeak_Nm - 10.0, kTable_Nm);
  EXPECT_NEAR(step_of(drives, -1e3, 2.0).torque_Nm[0], -kPeak_Nm - 10.0, kTable_Nm);
  EXPECT_EQ(step_of(drives, 0.0, 0.0).current_A[0], 0.0);
}

// Oracle: Kirchhoff. Without voltage no current flows, and what is left is the drag.
TEST(PoweredDrives, WithoutVoltageAreOff) {
  for (const DriveLimits limits : {DriveLimits::kMor, DriveLimits::kBox}) {
    Actuator actuator = actuator::round_actuator();
    actuator.effects = {actuator::effect("coulomb_friction", {5.0})};
    PoweredDriveOptions options;
    options.limits = limits;
    options.conditions.bus_voltage_V = 0.0;
    PoweredDrives drives = one_drive(actuator, options);
    for (const double speed_rad_s : {-3.0, 3.0}) {
      const DriveStep step = step_of(drives, 50.0, speed_rad_s);
      EXPECT_DOUBLE_EQ(step.torque_Nm[0], std::copysign(5.0, -speed_rad_s));
      EXPECT_EQ(step.current_A[0], 0.0);
      EXPECT_EQ(step.power_W, 0.0);
      EXPECT_EQ(step.bus_V[0], 0.0);
    }
    EXPECT_EQ(step_of(drives, 50.0, 0.0).torque_Nm[0], 0.0);
  }
}

/// Batteries that are strong, soft, weak, without voltage, or full.
std::vector<std::pair<Actuator, actuator::OperatingConditions>> hard_cases() {
  std::vector<std::pair<Actuator, actuator::OperatingConditions>> cases;
  for (const double resistance_ohm : {0.0, 0.05, 3.0, 1e6}) {
    cases.push_back({round_drive(resistance_ohm), {}});
  }
  cases.push_back(cases[1]);
  cases.back().second.bus_voltage_V = 0.0;
  cases.push_back(cases[1]);
  cases.back().first.battery->maximum_voltage_V = 50.0;
  cases.push_back(cases[1]);
  cases.back().first.battery->discharge_limit_A = 0.0;
  cases.push_back(cases[1]);
  cases.back().first.drive.regeneration = false;
  cases.push_back(cases[1]);
  Actuator& all = cases.back().first;
  all.motor.inductance_d_H = 1e-4;
  all.motor.inductance_q_H = 2e-4;
  all.motor.pole_pairs = 10.0;
  all.drive.field_weakening = true;
  all.thermal = actuator::Thermal{0.5, 1.0, 20.0, 50.0, 400.0};
  all.effects = {actuator::effect("torque_constant_saturation", {40.0, 2.0}),
                 actuator::effect("inverter_dead_time", {0.5}),
                 actuator::effect("coulomb_friction", {3.0}),
                 actuator::effect("load_dependent_friction", {0.1, 0.1})};
  cases.push_back(cases.back());
  cases.back().second.bus_voltage_V = 1e-3;
  return cases;
}

// Oracle: what must hold whatever is asked: numbers, bookkeeping, and the battery's limits.
TEST(PoweredDrives, StandExtremesOfEitherSign) {
  const double speeds_rad_s[] = {0.0, 1e-300, 1e-9, 1.0, 9.99, 10.0, 10.01, 14.0, 50.0, 1e4};
  for (const DriveLimits limits : {DriveLimits::kMor, DriveLimits::kBox}) {
    for (const auto& [actuator, conditions] : hard_cases()) {
      PoweredDrives drives = one_drive(actuator, {limits, conditions, alone(2.0)});
      for (const double wanted_Nm : {0.0, 1e-300, 1.0, 199.0, 1e4, 1e300}) {
        for (const double speed_rad_s : speeds_rad_s) {
          for (int signs = 0; signs < 4; ++signs) {
            const double wants_Nm = signs % 2 == 0 ? wanted_Nm : -wanted_Nm;
            const DriveStep step =
                step_of(drives, wants_Nm, signs < 2 ? speed_rad_s : -speed_rad_s);
            ASSERT_TRUE(step.torque_Nm.allFinite() && step.cut_off_Nm.allFinite() &&
                        step.current_A.allFinite() && step.winding_K.allFinite() &&
                        step.bus_V.allFinite() && std::isfinite(step.power_W))
                << wants_Nm << " Nm, " << speed_rad_s << " rad/s";
            EXPECT_GE(step.current_A[0], 0.0);
            EXPECT_GE(step.bus_V[0], 0.0);
            // All of a torque of this size is friction's, the region's or cut off.
            EXPECT_LE(std::abs(step.torque_Nm[0]), 2.0 * kPeak_Nm);
            if (limits == DriveLimits::kBox || step.cut_off_Nm[0] == 0.0) continue;
            EXPECT_LE(std::abs(step.cut_off_Nm[0]), wanted_Nm + 2.0 * kPeak_Nm);
          }
        }
      }
    }
  }
}

// Oracle: the battery's limit. Whatever the drives would return is cut until what is returned is
// what it takes: nothing, where it is full.
TEST(PoweredDrives, ReturnNoMoreThanTheBatteryTakes) {
  Actuator full = round_drive(0.1);
  full.battery->maximum_voltage_V = 50.0;
  PoweredDrives drives = one_drive(full);
  const DriveStep step = step_of(drives, -60.0, 8.0);  // -480 W, and 72 W of copper
  EXPECT_TRUE(step.is_starved);
  EXPECT_NEAR(step.power_W, 0.0, 1e-5);
  // 5 i w = R i^2 is where nothing flows: 80 A, beyond what is asked; so only none at all is left.
  EXPECT_NEAR(step.torque_Nm[0], 0.0, 1e-6);
  Actuator limited = round_drive(0.1);
  limited.battery->charge_limit_A = 4.0;  // 4 A at 50.4 V
  PoweredDrives some = one_drive(limited);
  const DriveStep part = step_of(some, -60.0, 8.0);
  EXPECT_TRUE(part.is_starved);
  EXPECT_NEAR(part.power_W, -4.0 * 50.4, 1e-5);
  EXPECT_NEAR(part.bus_V[0], 50.4, 1e-7);
  // 0.5 i^2 - 40 i = -201.6
  const double current_A = 40.0 - std::sqrt(1600.0 - 2.0 * 201.6);
  EXPECT_NEAR(part.torque_Nm[0], -kNmPerAmpere * current_A, 1e-5);
  EXPECT_FALSE(step_of(some, -20.0, 8.0).is_starved);
}

// Oracle: maximum power transfer. A source gives Voc^2 / 4 R at most, at half its voltage, and all
// drives on it lose one share of their motors' torque.
TEST(PoweredDrives, ShareWhatAWeakBatteryGives) {
  constexpr double kBattery_ohm = 2.5;  // 250 W
  PoweredDrives drives(driven_robot({round_drive(kBattery_ohm), round_drive(kBattery_ohm)}), {});
  const Vector2d wanted_Nm(100.0, 60.0);
  const Vector2d speed_rad_s(1.0, 2.0);
  const DriveStep step = drives.drive(wanted_Nm, Vector2d::Zero(), speed_rad_s, kStep_s);
  EXPECT_TRUE(step.is_starved);
  EXPECT_NEAR(step.power_W, 250.0, 1e-5);
  EXPECT_NEAR(step.bus_V[0], 25.0, 0.02);  // as the root of 1e-5 W is: sqrt(R 1e-5) V
  EXPECT_NEAR(step.torque_Nm[0] / wanted_Nm[0], step.torque_Nm[1] / wanted_Nm[1], 1e-9);
  // s (100 + 120) + s^2 0.5 (20^2 + 12^2) = 250
  const double share = (-220.0 + std::sqrt(220.0 * 220.0 + 4.0 * 272.0 * 250.0)) / (2.0 * 272.0);
  EXPECT_NEAR(step.torque_Nm[0], share * 100.0, 1e-5);
  EXPECT_FALSE(
      drives.drive(Vector2d(10.0, 10.0), Vector2d::Zero(), speed_rad_s, kStep_s).is_starved);
  Actuator limited = round_drive(0.1);
  limited.battery->discharge_limit_A = 5.0;  // 5 A at 49.5 V
  PoweredDrives fused = one_drive(limited);
  EXPECT_NEAR(step_of(fused, 150.0, 4.0).power_W, 5.0 * 49.5, 1e-5);
}

// Oracle: the rectangle itself.
TEST(PoweredDrives, InABoxKnowNeitherVoltageNorBattery) {
  for (const double resistance_ohm : {0.0, 0.1, 5.0}) {
    PoweredDrives drives = one_drive(round_drive(resistance_ohm), {DriveLimits::kBox, {}, {}});
    EXPECT_DOUBLE_EQ(step_of(drives, 150.0, 9.9).torque_Nm[0], 150.0);
    EXPECT_NEAR(step_of(drives, 1e3, 9.9).torque_Nm[0], kPeak_Nm, 1e-9);
    EXPECT_NEAR(step_of(drives, -1e3, -9.9).torque_Nm[0], -kPeak_Nm, 1e-9);
    EXPECT_EQ(step_of(drives, 150.0, 10.1).torque_Nm[0], 0.0);
    EXPECT_EQ(step_of(drives, -150.0, -10.1).torque_Nm[0], 0.0);
    EXPECT_DOUBLE_EQ(step_of(drives, -150.0, 10.1).torque_Nm[0], -150.0);
    EXPECT_DOUBLE_EQ(step_of(drives, 150.0, -30.0).torque_Nm[0], 150.0);
    EXPECT_EQ(step_of(drives, 150.0, 9.0).is_starved, resistance_ohm == 5.0);
  }
}

// Oracle: the exact solution of both nodes under a constant current, docs/derivations/check.md
// eqs. (5), (6). A step takes the loss of its beginning: so it is off by what the loss grows in a
// step, at most the growth's rate times the step of all the warmth.
TEST(PoweredDrives, WarmAsTwoNodesUnderAConstantCurrent) {
  Actuator actuator = actuator::round_actuator();
  actuator.thermal = actuator::Thermal{0.5, 1.0, 40.0, 100.0, 500.0, 300.0};
  PoweredDrives drives = one_drive(actuator);
  constexpr double kCurrent_A = 20.0;
  constexpr double kDuration_s = 8.0;
  constexpr double kLong_s = 2e-3;
  const actuator::HeatModel heat(actuator);
  const double phase_A =
      kCurrent_A * phase_amperes_per_ampere(actuator.motor.torque_constant_convention);
  const actuator::Warmth exact = heat.step(phase_A * phase_A, kDuration_s).after({0.0, 0.0});
  double winding_K = 0.0;
  for (int i = 0; i < static_cast<int>(kDuration_s / kLong_s); ++i) {
    winding_K = drives.drive(alone(kCurrent_A * kNmPerAmpere), alone(0.0), alone(0.0), kLong_s)
                    .winding_K[0];
  }
  const double growth_1_s =
      kCurrent_A * kCurrent_A * kWinding_ohm * actuator::kCopperCoefficient_1_K / 40.0;
  EXPECT_GT(exact[0], 30.0);
  EXPECT_NEAR(winding_K, 300.0 + exact[0], growth_1_s * kLong_s * exact[0]);
  EXPECT_TRUE(drives.has_heat(0));
  PoweredDrives cold = one_drive(actuator::round_actuator());
  EXPECT_FALSE(cold.has_heat(0));
  EXPECT_EQ(step_of(cold, 100.0, 0.0).winding_K[0], actuator::kDefaultTemperature_K);
}

// Oracle: copper's law in Ohm's. At a level of the temperature as between two, where the bound, as
// 1/R, bends by less than (0.0039 * 5 K)^2 / 4 of itself.
TEST(PoweredDrives, LoseTorqueAsTheirWindingWarms) {
  for (const double warmth_K : {0.0, 50.0, 51.3, 102.5}) {
    PoweredDriveOptions options;
    options.conditions.winding_temperature_K = actuator::kDefaultTemperature_K + warmth_K;
    PoweredDrives drives = one_drive(actuator::round_actuator(), options);
    const double warm_ohm = kWinding_ohm * (1.0 + actuator::kCopperCoefficient_1_K * warmth_K);
    const double bound_Nm = kNmPerAmpere * (50.0 - 5.0 * 8.0) / warm_ohm;
    const DriveStep step = step_of(drives, 1e3, 8.0);
    EXPECT_NEAR(step.torque_Nm[0], bound_Nm, kTable_Nm + 1e-4 * bound_Nm) << warmth_K;
    const double current_A = step.torque_Nm[0] / kNmPerAmpere;
    EXPECT_NEAR(step.power_W, 8.0 * step.torque_Nm[0] + warm_ohm * current_A * current_A, 1e-9);
  }
}

// Oracle: friction only takes. A flywheel that the friction alone moves never gains energy and
// never turns round, at any step, and loses what Coulomb's law says while it is fast.
TEST(PoweredDrives, FurtherFrictionTakesEnergyAndNeverGivesIt) {
  for (const double rotor_kg_m2 : {1e-5, 2e-4, 1e-2}) {
    for (const double step_s : {1e-4, 5e-4, 1e-2}) {
      Actuator actuator = actuator::round_actuator();
      actuator.motor.rotor_inertia_kg_m2 = rotor_kg_m2;
      const double inertia_kg_m2 = 100.0 * rotor_kg_m2;  // the rotor alone: what moves the least
      PoweredDrives drives = one_drive(actuator, {DriveLimits::kMor, {}, alone(0.7)});
      double speed_rad_s = 3.0;
      for (int i = 0; i < 3000; ++i) {
        const double torque_Nm =
            drives.drive(alone(0.0), alone(0.0), alone(speed_rad_s), step_s).torque_Nm[0];
        EXPECT_LE(torque_Nm * speed_rad_s, 0.0);
        // Of the no-load speed a thousandth, or what the friction takes in a step.
        const double width_rad_s = std::max(0.01, 0.7 * step_s / inertia_kg_m2);
        EXPECT_NEAR(torque_Nm, -0.7 * std::min(1.0, speed_rad_s / width_rad_s), 1e-12);
        const double next_rad_s = speed_rad_s + step_s * torque_Nm / inertia_kg_m2;
        ASSERT_LE(std::abs(next_rad_s), std::abs(speed_rad_s));
        ASSERT_GE(next_rad_s * speed_rad_s, 0.0);
        speed_rad_s = next_rad_s;
      }
    }
  }
}

/// Torques and speeds of a trial, the same whenever they are asked for.
std::vector<DriveStep> trial(PoweredDrives& drives, unsigned number) {
  std::mt19937 dice(number);
  std::uniform_real_distribution<double> torque(-300.0, 300.0);
  std::uniform_real_distribution<double> speed(-11.0, 11.0);
  std::vector<DriveStep> steps;
  for (int i = 0; i < 400; ++i) {
    const Vector2d wanted_Nm(torque(dice), torque(dice));
    steps.push_back(
        drives.drive(wanted_Nm, Vector2d::Zero(), Vector2d(speed(dice), speed(dice)), 1e-2));
  }
  return steps;
}

void expect_same(const std::vector<DriveStep>& ones, const std::vector<DriveStep>& others) {
  ASSERT_EQ(ones.size(), others.size());
  for (std::size_t i = 0; i < ones.size(); ++i) {
    ASSERT_EQ(ones[i].torque_Nm, others[i].torque_Nm) << i;
    ASSERT_EQ(ones[i].current_A, others[i].current_A) << i;
    ASSERT_EQ(ones[i].winding_K, others[i].winding_K) << i;
    ASSERT_EQ(ones[i].bus_V, others[i].bus_V) << i;
    ASSERT_EQ(ones[i].power_W, others[i].power_W) << i;
  }
}

Robot warm_robot() {
  Actuator actuator = round_drive(0.1);
  actuator.thermal = actuator::Thermal{0.5, 1.0, 20.0, 100.0, 500.0};
  return driven_robot({actuator, actuator});
}

// Oracle: the first run itself, bit by bit.
TEST(PoweredDrives, ForgetWhenTheyStart) {
  PoweredDrives drives(warm_robot(), {});
  const std::vector<DriveStep> first = trial(drives, 1);
  EXPECT_GT(first.back().winding_K[0], 310.0);
  trial(drives, 2);
  drives.start();
  expect_same(first, trial(drives, 1));
}

// Oracle: trials one after another, each with drives of its own, bit by bit. Copies that share
// their regions and ask for them in any order, on several threads, find nothing else.
TEST(PoweredDrives, AreTheSameOnAnyThreadInAnyOrder) {
  constexpr unsigned kTrials = 8;
  const Robot robot = warm_robot();
  std::vector<std::vector<DriveStep>> alone_each(kTrials);
  for (unsigned i = 0; i < kTrials; ++i) {
    PoweredDrives drives(robot, {});
    alone_each[i] = trial(drives, i);
  }
  std::vector<std::vector<DriveStep>> together(kTrials);
  const PoweredDrives shared(robot, {});
  std::vector<std::thread> threads;
  for (unsigned thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      for (const unsigned i : {kTrials - 1 - thread, thread}) {
        PoweredDrives copy(shared);
        together[i] = trial(copy, i);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (unsigned i = 0; i < kTrials; ++i) expect_same(alone_each[i], together[i]);
}

// Oracle: drives that were made under the other options, bit by bit.
TEST(PoweredDrives, UnderOtherOptionsAreAsIfMadeUnderThem) {
  Robot robot = warm_robot();
  for (Drivetrain& drivetrain : robot.drivetrains) {
    drivetrain.actuators[0].battery->cell_open_circuit = {{0.0, 40.0}, {1.0, 50.0}};
  }
  PoweredDriveOptions half;
  half.conditions.state_of_charge = 0.53;
  half.further_friction_Nm = Vector2d(0.3, 0.4);
  half.motor_strength_factor = Vector2d(0.9, 1.2);
  PoweredDrives full(robot, {});
  trial(full, 3);
  PoweredDrives changed(full);
  changed = full.under(half);
  PoweredDrives made(robot, half);
  const std::vector<DriveStep> steps = trial(made, 4);
  EXPECT_LT(steps.front().bus_V[0], 49.0);
  expect_same(steps, trial(changed, 4));
  half.limits = DriveLimits::kBox;
  half.conditions.rating = actuator::Rating::kContinuous;
  PoweredDrives boxed = changed.under(half);
  PoweredDrives boxed_too(robot, half);
  expect_same(trial(boxed_too, 5), trial(boxed, 5));
}

// By hand: the motor makes (torque + 0.3 Nm of friction) at the output while it turns forward; of
// another strength four fifths of it, for the same current and power, and the friction stays. At
// rest nothing rubs.
TEST(PoweredDrives, OfAnotherStrengthMakeThatShareOfTheirMotorsTorque) {
  Actuator actuator = round_drive(0.1);
  actuator.effects = {actuator::effect("coulomb_friction", {0.3})};
  PoweredDriveOptions weak;
  weak.motor_strength_factor = alone(0.8);
  PoweredDrives drives = one_drive(actuator);
  PoweredDrives weaker = drives.under(weak);
  for (const double wanted_Nm : {-60.0, 0.0, 25.0, 1e4}) {
    for (const double speed_rad_s : {-4.0, 0.0, 4.0}) {
      const DriveStep full = step_of(drives, wanted_Nm, speed_rad_s);
      const DriveStep less = step_of(weaker, wanted_Nm, speed_rad_s);
      const double drag_Nm = speed_rad_s == 0.0 ? 0.0 : std::copysign(0.3, speed_rad_s);
      EXPECT_NEAR(less.torque_Nm[0], 0.8 * (full.torque_Nm[0] + drag_Nm) - drag_Nm, 1e-9)
          << wanted_Nm << " Nm at " << speed_rad_s;
      EXPECT_EQ(less.current_A[0], full.current_A[0]);
      EXPECT_EQ(less.power_W, full.power_W);
      EXPECT_EQ(less.cut_off_Nm[0], full.cut_off_Nm[0]);
    }
  }
  weak.motor_strength_factor = alone(0.0);
  EXPECT_THROW(one_drive(actuator, weak), std::invalid_argument);
}

// Oracle: the same motor with a torque constant of four fifths, whose back-EMF is stated and stays:
// it takes the same current for the torque that acts.
TEST(PoweredDrives, OfAnotherStrengthAreAMotorOfAnotherTorqueConstant) {
  Actuator actuator = round_drive(0.1);
  actuator.effects = {actuator::effect("coulomb_friction", {0.3})};
  actuator.motor.back_emf_constant_V_s_rad = actuator.motor.torque_constant_Nm_A;
  Actuator other = actuator;
  other.motor.torque_constant_Nm_A *= 0.8;
  PoweredDriveOptions weak;
  weak.motor_strength_factor = alone(0.8);
  PoweredDrives drives = one_drive(actuator, weak);
  PoweredDrives others = one_drive(other);
  for (const double wanted_Nm : {-60.0, 25.0, 70.0}) {
    const DriveStep step = step_of(drives, wanted_Nm, 2.0);
    const DriveStep same = step_of(others, step.torque_Nm[0], 2.0);
    EXPECT_NEAR(same.torque_Nm[0], step.torque_Nm[0], 1e-9);
    EXPECT_NEAR(same.current_A[0], step.current_A[0], 1e-9);
  }
}

TEST(PoweredDrives, OfARobotWithoutAnyDoNothing) {
  PoweredDrives drives(driven_robot({}), {});
  EXPECT_EQ(drives.size(), 0);
  const DriveStep& step = drives.drive(VectorXd(), VectorXd(), VectorXd(), kStep_s);
  EXPECT_EQ(step.torque_Nm.size(), 0);
  EXPECT_EQ(step.power_W, 0.0);
}

TEST(PoweredDrives, RefuseWhatIsNoStep) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  PoweredDrives drives = one_drive(actuator::round_actuator());
  EXPECT_EQ(drives.size(), 1);
  EXPECT_THROW(drives.drive(alone(kNaN), alone(0.0), alone(0.0), kStep_s), std::invalid_argument);
  EXPECT_THROW(drives.drive(alone(0.0), alone(0.0), alone(kNaN), kStep_s), std::invalid_argument);
  EXPECT_THROW(drives.drive(alone(0.0), alone(kNaN), alone(0.0), kStep_s), std::invalid_argument);
  EXPECT_THROW(drives.drive(alone(0.0), alone(0.0), alone(HUGE_VAL), kStep_s),
               std::invalid_argument);
  EXPECT_THROW(drives.drive(alone(0.0), alone(0.0), Vector2d(0.0, 0.0), kStep_s),
               std::invalid_argument);
  EXPECT_THROW(drives.drive(alone(0.0), alone(0.0), alone(0.0), 0.0), std::invalid_argument);
  EXPECT_THROW(drives.drive(alone(0.0), alone(0.0), alone(0.0), kNaN), std::invalid_argument);
  EXPECT_THROW(one_drive(actuator::round_actuator(), {DriveLimits::kMor, {}, alone(-1.0)}),
               std::invalid_argument);
  EXPECT_THROW(one_drive(actuator::round_actuator(), {DriveLimits::kMor, {}, Vector2d(0.0, 0.0)}),
               std::invalid_argument);
  PoweredDriveOptions options;
  options.conditions.state_of_charge = 0.5;  // of no battery
  EXPECT_THROW(one_drive(actuator::round_actuator(), options), io::SpecError);
  EXPECT_THROW(drives.under(options), io::SpecError);
}

}  // namespace
}  // namespace torquewright::hopper
