// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/motor_region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "actuator/region/operating_conditions.hpp"
#include "actuator/region/range_by_search.hpp"
#include "actuator/region/voltage_disc.hpp"
#include "tests/actuator/dq_oracle.hpp"
#include "tests/actuator/example_actuator.hpp"
#include "tests/actuator/random_actuator.hpp"

namespace torquewright::actuator {
namespace {

/// The motor of the reference's dq table: p 21, lambda 0.0024 Wb, L 30 uH, R 0.105, 24 V, 40 A.
PhaseModel reference_model(double inductance_H, bool field_weakening) {
  PhaseModel model;
  model.torque_constant_Nm_A = 0.0756;
  model.back_emf_V_s_rad = 21.0 * 0.0024;
  model.resistance_ohm = 0.105;
  model.inductance_d_H = model.inductance_q_H = inductance_H;
  model.pole_pairs = 21.0;
  model.current_limit_A = 40.0;
  model.demagnetisation_current_A = kUnlimited;
  model.field_weakening = field_weakening;
  model.supply = {24.0, 0.0, kUnlimited, -kUnlimited};
  model.phase_volts_per_bus_volt = 1.0 / std::sqrt(3.0);
  return model;
}

// Oracle: the reference's brute force (actuator.md 2.5, printed to 0.001 Nm).
TEST(MotorRange, GivesTheTorquesOfTheReferencesDqTable) {
  struct Row {
    double speed_rad_s, line_Nm, dq_Nm, weakened_Nm;
  };
  for (const Row& row : {Row{180.0, 3.024, 2.930, 3.019}, Row{220.0, 1.993, 1.729, 2.633},
                         Row{260.0, 0.542, 0.510, 2.173}}) {
    const auto greatest_Nm = [&](const PhaseModel& model) {
      return motor_range(model, row.speed_rad_s).greatest.torque_Nm;
    };
    EXPECT_NEAR(greatest_Nm(reference_model(0.0, false)), row.line_Nm, 0.00051);
    EXPECT_NEAR(greatest_Nm(reference_model(3e-5, false)), row.dq_Nm, 0.00051);
    EXPECT_NEAR(greatest_Nm(reference_model(3e-5, true)), row.weakened_Nm, 0.00051);
    EXPECT_NEAR(motor_range(reference_model(3e-5, true), row.speed_rad_s).least.torque_Nm, -3.024,
                1e-12);
  }
}

// Oracle: the closed forms of the quasi-static line: corner (V - R cap/K)/K, no load V/K, overspeed
// (V + R cap/K)/K, torque K (V - K w)/R between.
TEST(MotorRange, IsTheParallelogramOfTheQuasiStaticLine) {
  const PhaseModel model = phase_model_at(round_actuator(), {});
  const auto greatest = [&](double w) { return motor_range(model, w).greatest; };
  EXPECT_NEAR(greatest(0.0).torque_Nm, 20.0, 1e-12);
  EXPECT_NEAR(greatest(59.999).torque_Nm, 20.0, 1e-12);
  EXPECT_EQ(greatest(59.999).limiter, Limiter::kCurrent);
  EXPECT_NEAR(greatest(60.002).torque_Nm, 20.0 - 0.5 * 0.002, 1e-12);
  EXPECT_EQ(greatest(60.002).limiter, Limiter::kVoltage);
  EXPECT_NEAR(greatest(100.0).torque_Nm, 0.0, 1e-12);
  EXPECT_NEAR(greatest(120.0).torque_Nm, -10.0, 1e-12);
  EXPECT_NEAR(motor_range(model, 120.0).least.torque_Nm, -20.0, 1e-12);
  EXPECT_NEAR(greatest_speed_rad_s(model, 400.0), 140.0, 1e-9);
  EXPECT_TRUE(motor_range(model, 140.001).is_empty);
  EXPECT_EQ(motor_range(model, 140.001).why_empty, Limiter::kVoltage);
}

// Oracle: RaiSim 2's documented motor: R 0.2, Kt 0.1, 24 V, peak 1.5: 240 rad/s without load, and
// 0.1 Nm left at 238.
TEST(MotorRange, GivesTheNumbersOfRaiSimsDocumentation) {
  Actuator actuator;
  actuator.motor.torque_constant_Nm_A = 0.1;
  actuator.motor.resistance_ohm = 0.2;
  actuator.drive.bus_voltage_V = 24.0;
  actuator.drive.peak_current_A = 15.0;
  actuator.transmission.ratio = 10.0;
  const PhaseModel model = phase_model_at(actuator, {});
  EXPECT_NEAR(motor_range(model, 0.0).greatest.torque_Nm, 1.5, 1e-12);
  EXPECT_NEAR(no_load_speed_rad_s(model), 240.0, 1e-10);
  EXPECT_NEAR(motor_range(model, 238.0).greatest.torque_Nm, 0.1, 1e-12);
}

TEST(MotorRange, IsTheSameBackwards) {
  const PhaseModel model = reference_model(3e-5, true);
  for (const double w : {0.0, 100.0, 220.0, 300.0}) {
    const MotorRange forward = motor_range(model, w);
    const MotorRange backward = motor_range(model, -w);
    EXPECT_EQ(forward.greatest.torque_Nm, -backward.least.torque_Nm);
    EXPECT_EQ(forward.greatest.limiter, backward.least.limiter);
    EXPECT_EQ(forward.least.bus_power_W, backward.greatest.bus_power_W);
  }
}

// Oracle: brute force over (i_d, i_q), see dq_oracle.hpp. Its grid misses the bound by at most a
// step of current; the search must be beyond it, and no further than that.
void compare_with_brute_force(const PhaseModel& model, double speed_rad_s) {
  constexpr int kRings = 400;
  constexpr int kRays = 1440;
  const auto brute = oracles::brute_force_range(model, speed_rad_s, kRings, kRays);
  const MotorRange range = motor_range(model, speed_rad_s);
  const double cap_Nm =
      model.torque_constant_Nm_A * model.current_limit_A +
      std::abs(model.reluctance_Nm_A2()) * model.current_limit_A * model.current_limit_A;
  const double beyond_Nm = 1e-9 * cap_Nm;
  const double short_Nm = 0.02 * cap_Nm;
  if (range.is_empty) {
    EXPECT_FALSE(brute) << speed_rad_s;
    return;
  }
  if (!brute) {  // the grid may miss a sliver
    EXPECT_LT(range.greatest.torque_Nm - range.least.torque_Nm, short_Nm) << speed_rad_s;
    return;
  }
  EXPECT_GE(range.greatest.torque_Nm, brute->greatest_Nm - beyond_Nm) << speed_rad_s;
  EXPECT_LE(range.greatest.torque_Nm, brute->greatest_Nm + short_Nm) << speed_rad_s;
  EXPECT_LE(range.least.torque_Nm, brute->least_Nm + beyond_Nm) << speed_rad_s;
  EXPECT_GE(range.least.torque_Nm, brute->least_Nm - short_Nm) << speed_rad_s;
}

TEST(MotorRange, AgreesWithBruteForceOverCurrents) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    RandomActuatorOptions options;
    options.with_effects = false;
    options.regeneration_limits = false;  // a gap in the middle is no range for the oracle
    options.field_weakening = seed % 2 == 0;
    const PhaseModel model = phase_model_at(random_actuator(seed, options), {});
    const double no_load_rad_s = no_load_speed_rad_s(model);
    for (const double share : {0.0, 0.4, 0.8, 0.97, 1.1, 1.4}) {
      compare_with_brute_force(model, share * no_load_rad_s);
    }
  }
}

// Salient machines: reluctance torque, so that the least current has a d part.
TEST(MotorRange, AgreesWithBruteForceForUnequalInductances) {
  for (const double quotient : {0.5, 2.0, 4.0}) {
    PhaseModel model = reference_model(3e-5, true);
    model.inductance_q_H = 3e-5 * quotient;
    for (const double w : {0.0, 120.0, 200.0, 280.0, 360.0}) compare_with_brute_force(model, w);
  }
}

// Magnets so weak beside the reluctance that 16 A of negative d current, of 40 A, turn the flux
// around: an end beyond is no end of the drive's.
TEST(MotorRange, AgreesWithBruteForceWhereTheFluxCouldTurn) {
  PhaseModel model = reference_model(3e-5, true);
  model.torque_constant_Nm_A = 0.03;
  model.pole_pairs = 14.0;
  model.back_emf_V_s_rad = 0.02;  // 3/2 of it is Kt
  model.resistance_ohm = 0.12;
  model.inductance_d_H = 1.2e-4;
  for (double w = 300.0; w <= 760.0; w += 20.0) compare_with_brute_force(model, w);
}

void expect_same(const MotorRange& one, const MotorRange& other, double tolerance_Nm) {
  ASSERT_EQ(one.is_empty, other.is_empty);
  if (one.is_empty) return;
  EXPECT_NEAR(one.greatest.torque_Nm, other.greatest.torque_Nm, tolerance_Nm);
  EXPECT_NEAR(one.least.torque_Nm, other.least.torque_Nm, tolerance_Nm);
  EXPECT_EQ(one.greatest.limiter, other.greatest.limiter);
  EXPECT_EQ(one.least.limiter, other.least.limiter);
}

// Oracle: the search by brackets. A trace of battery resistance leaves the circles for Newton's
// method, a trace of dead time that for bracketing; neither moves a bound. The bound's error where
// the range is flat in i_d is that of the voltage, 1e-12, over the least slope; 1e-7 leaves room
// for the top of the disc, where torque falls as the square root of what is missing.
TEST(MotorRange, IsTheSameByCirclesByNewtonAndByBrackets) {
  int compared = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    RandomActuatorOptions options;
    options.with_effects = false;
    options.field_weakening = seed % 3 != 0;
    const Actuator actuator = random_actuator(seed, options);
    PhaseModel circles = phase_model_at(actuator, {});
    circles.supply.resistance_ohm = 0.0;
    if (seed % 4 == 1) circles.inductance_q_H *= 2.0;  // then only Newton against brackets
    if (seed % 5 == 2) circles.demagnetisation_current_A = 0.3 * circles.current_limit_A;
    PhaseModel newton = circles;
    newton.supply.resistance_ohm = 1e-13 * circles.resistance_ohm;
    PhaseModel brackets = newton;
    brackets.dead_time_V = 1e-13 * circles.supply.open_circuit_V;
    const double cap_Nm = circles.torque_constant_Nm_A * circles.current_limit_A;
    for (const double share : {0.0, 0.3, 0.7, 0.9, 0.99, 1.03, 1.2, 1.7}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << " at " << share);
      const double w = share * no_load_speed_rad_s(circles);
      const MotorRange range = motor_range(circles, w);
      for (const PhaseModel& model : {newton, brackets}) {
        expect_same(range, motor_range(model, w), 1e-7 * cap_Nm);
        expect_same(range, motor_range_by_search(model, w), 1e-7 * cap_Nm);
      }
      compared += range.is_empty ? 0 : 1;
    }
  }
  EXPECT_GT(compared, 600);
}

/// A model of any kind: with or without unequal inductances, saturation, dead time, a battery and
/// its limits, demagnetisation, field weakening.
PhaseModel model_of_any_kind(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto may = [&] { return std::bernoulli_distribution(0.5)(random); };
  RandomActuatorOptions options;
  options.with_effects = false;
  options.regeneration_limits = false;
  options.field_weakening = true;
  PhaseModel model = phase_model_at(random_actuator(seed, options), {});
  const double open_V = model.supply.open_circuit_V;
  const double limit_A = model.current_limit_A;
  model.supply.greatest_power_W = kUnlimited;
  model.field_weakening = seed % 4 != 0;
  if (may()) model.inductance_q_H *= between(0.4, 4.0);
  if (may()) model.saturation_current_A = between(0.5, 3.0) * limit_A;
  if (may()) model.dead_time_V = between(0.001, 0.02) * open_V;
  if (may()) model.demagnetisation_current_A = between(0.1, 1.1) * limit_A;
  if (seed % 3 == 0) model.supply.greatest_power_W = between(0.1, 1.0) * open_V * limit_A;
  if (seed % 5 == 0) model.supply.least_power_W = -between(0.0, 0.3) * open_V * limit_A;
  return model;
}

// Oracle: the search by brackets, which knows no derivative and no condition of an optimum. Its own
// error, 1e-8 of the current where it seeks a top, is the greatest here.
TEST(MotorRange, IsWhatASearchWithoutDerivativesFinds) {
  int compared = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const PhaseModel model = model_of_any_kind(seed);
    const double cap_Nm = model.torque_constant_Nm_A * model.current_limit_A;
    for (const double share : {0.0, 0.3, 0.7, 0.95, 1.1, 1.5, 2.5}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << " at " << share);
      const double w = share * no_load_speed_rad_s(model);
      if (voltage_disc(model, w, 0.0)) continue;  // circles have a test of their own
      const MotorRange range = motor_range(model, w);
      expect_same(range, motor_range_by_search(model, w), 1e-7 * cap_Nm);
      compared += range.is_empty ? 0 : 1;
    }
  }
  EXPECT_GT(compared, 1500);
}

// Oracle: the search, asked on both sides of the end.
TEST(MotorRange, EndsAtTheSpeedAtWhichTheSearchFindsNothingMore) {
  int compared = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const PhaseModel model = model_of_any_kind(seed);
    const double most_rad_s = 4.0 * no_load_speed_rad_s(model);
    const double end_rad_s = greatest_speed_rad_s(model, most_rad_s);
    EXPECT_FALSE(motor_range(model, end_rad_s).is_empty) << seed;
    if (end_rad_s == most_rad_s) continue;
    EXPECT_FALSE(motor_range_by_search(model, (1.0 - 1e-7) * end_rad_s).is_empty) << seed;
    EXPECT_TRUE(motor_range_by_search(model, (1.0 + 1e-7) * end_rad_s).is_empty) << seed;
    ++compared;
  }
  EXPECT_GT(compared, 30);
}

TEST(MotorRange, NamesDemagnetisationWhereItLimits) {
  PhaseModel model = reference_model(3e-5, true);
  model.demagnetisation_current_A = 5.0;
  const MotorRange range = motor_range(model, 260.0);
  EXPECT_EQ(range.greatest.limiter, Limiter::kDemagnetisation);
  compare_with_brute_force(model, 260.0);
}

// Oracle: closed form of the sag. At i amperes (dc) and w, V - R_b P/V = bus with P = K i w + R
// i^2; at the bound R i + K w = bus, so that with I_bus = P/bus: R i + K w = Voc - R_b i (since P =
// i (K w + R i) = i bus): i = (Voc - K w)/(R + R_b).
TEST(MotorRange, SagsAsTheClosedFormSays) {
  Actuator actuator = round_actuator();
  actuator.battery = Battery{};
  actuator.battery->cell_open_circuit = {{1.0, 50.0}};
  actuator.battery->cell_resistance_ohm = 0.1;
  const PhaseModel model = phase_model_at(actuator, {});
  for (const double w : {70.0, 80.0, 90.0, 99.0}) {
    const MotorRange range = motor_range(model, w);
    EXPECT_NEAR(range.greatest.torque_Nm, 0.5 * (50.0 - 0.5 * w) / 0.6, 1e-10);
    EXPECT_EQ(range.greatest.limiter, Limiter::kVoltage);
  }
}

// Oracle: P = K w i + R i^2 = P_max solved for i.
TEST(MotorRange, StopsAtTheBatterysPower) {
  Actuator actuator = round_actuator();
  actuator.battery = Battery{};
  actuator.battery->cell_open_circuit = {{1.0, 50.0}};
  actuator.battery->discharge_limit_A = 12.0;
  const MotorRange range = motor_range(phase_model_at(actuator, {}), 40.0);
  const double power_W = 600.0;
  const double i = (-20.0 + std::sqrt(400.0 + 4.0 * 0.5 * power_W)) / (2.0 * 0.5);
  EXPECT_NEAR(range.greatest.torque_Nm, 0.5 * i, 1e-10);
  EXPECT_NEAR(range.greatest.bus_power_W, power_W, 1e-8);
  EXPECT_EQ(range.greatest.limiter, Limiter::kBatteryPower);
}

// Oracle: the same with P = V I of the bus, which another voltage changes with it; of a battery, I
// (Voc - R I) at its lesser limit.
TEST(MotorRange, StopsAtTheSupplysCurrent) {
  const auto torque_at = [](double power_W) {
    return 0.5 * (-20.0 + std::sqrt(400.0 + 4.0 * 0.5 * power_W)) / (2.0 * 0.5);
  };
  Actuator actuator = round_actuator();
  actuator.drive.supply_current_A = 12.0;
  const auto range_of = [&](const OperatingConditions& conditions) {
    return motor_range(phase_model_at(actuator, conditions), 40.0);
  };
  EXPECT_NEAR(range_of({}).greatest.torque_Nm, torque_at(600.0), 1e-10);
  EXPECT_EQ(range_of({}).greatest.limiter, Limiter::kBatteryPower);
  OperatingConditions higher;
  higher.bus_voltage_V = 60.0;
  EXPECT_NEAR(range_of(higher).greatest.torque_Nm, torque_at(720.0), 1e-10);
  actuator.battery = Battery{};
  actuator.battery->cell_open_circuit = {{1.0, 50.0}};
  actuator.battery->cell_resistance_ohm = 0.1;
  actuator.battery->discharge_limit_A = 14.0;
  EXPECT_NEAR(range_of({}).greatest.torque_Nm, torque_at(12.0 * (50.0 - 1.2)), 1e-10);
  actuator.battery->discharge_limit_A = 10.0;
  EXPECT_NEAR(range_of({}).greatest.torque_Nm, torque_at(10.0 * (50.0 - 1.0)), 1e-10);
}

// Oracle: (5). From half the short circuit's 500 A on a limit of the current stands in no way: the
// bus never has so much.
TEST(MotorRange, IsNotStoppedByALimitThatTheBatteryCannotReach) {
  Actuator actuator = round_actuator();
  actuator.battery = Battery{};
  actuator.battery->cell_open_circuit = {{1.0, 50.0}};
  actuator.battery->cell_resistance_ohm = 0.1;
  const MotorRange unlimited = motor_range(phase_model_at(actuator, {}), 40.0);
  for (const double limit_A : {250.0, 499.0, 501.0, 1e6}) {
    actuator.battery->discharge_limit_A = limit_A;
    const MotorRange range = motor_range(phase_model_at(actuator, {}), 40.0);
    EXPECT_EQ(range.greatest.torque_Nm, unlimited.greatest.torque_Nm) << limit_A;
  }
}

// Oracle: without regeneration the region ends where P = 0, which is i = 0; plugging starts where
// R i^2 + K w i = 0 again, at i = -K w / R.
TEST(MotorRange, EndsAtZeroWithoutRegenerationAndReportsPlugging) {
  Actuator actuator = round_actuator();
  actuator.drive.regeneration = false;
  const PhaseModel model = phase_model_at(actuator, {});
  const MotorRange slow = motor_range(model, 30.0);
  EXPECT_NEAR(slow.least.torque_Nm, 0.0, 1e-12);
  EXPECT_EQ(slow.least.limiter, Limiter::kRegeneration);
  ASSERT_TRUE(slow.plugging);
  EXPECT_NEAR(slow.plugging->greatest_Nm, -0.5 * 0.5 * 30.0 / 0.5, 1e-10);
  EXPECT_NEAR(slow.plugging->least_Nm, -20.0, 1e-10);
  EXPECT_FALSE(motor_range(model, 90.0).plugging);  // 90 K/R is beyond 40 A
  const MotorRange fast = motor_range(model, 110.0);
  EXPECT_TRUE(fast.is_empty);
  EXPECT_EQ(fast.why_empty, Limiter::kRegeneration);
}

// The same backwards: the model knows no direction.
TEST(MotorRange, ReportsPluggingBackwardsWhereThereIsSome) {
  Actuator actuator = round_actuator();
  actuator.drive.regeneration = false;
  const PhaseModel model = phase_model_at(actuator, {});
  const MotorRange slow = motor_range(model, -30.0);
  ASSERT_TRUE(slow.plugging);
  EXPECT_NEAR(slow.plugging->least_Nm, 0.5 * 0.5 * 30.0 / 0.5, 1e-10);
  EXPECT_NEAR(slow.plugging->greatest_Nm, 20.0, 1e-10);
  EXPECT_FALSE(motor_range(model, -90.0).plugging);
}

// Oracle: electrical in = copper + bridge + shaft at every bound, from its own current and voltage:
// 1.5 (v_d i_d + v_q i_q), with saturation absent and the back-EMF that goes with the constant.
TEST(MotorRange, ConservesPowerAtEveryBound) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    RandomActuatorOptions options;
    options.with_effects = false;
    const PhaseModel model = phase_model_at(random_actuator(seed, options), {});
    for (const double share : {0.0, 0.5, 0.95, 1.05}) {
      const double w = share * no_load_speed_rad_s(model);
      const MotorRange range = motor_range(model, w);
      if (range.is_empty) continue;
      for (const MotorBound& bound : {range.least, range.greatest}) {
        const double electrical = model.pole_pairs * w;
        const double d = bound.current.d_A;
        const double q = bound.current.q_A;
        const double v_d = model.resistance_ohm * d - electrical * model.inductance_q_H * q;
        const double v_q = model.resistance_ohm * q + electrical * model.inductance_d_H * d +
                           model.back_emf_V_s_rad * w;
        const double scale_W = 1.0 + std::abs(bound.bus_power_W) + std::abs(bound.torque_Nm * w);
        EXPECT_NEAR(bound.bus_power_W, 1.5 * (v_d * d + v_q * q), 1e-9 * scale_W) << seed;
      }
    }
  }
}

// Oracle: the saturated torque at the current limit, and its inverse.
TEST(PhaseModel, SaturatesAndInverts) {
  PhaseModel model = reference_model(0.0, false);
  model.saturation_current_A = 30.0;
  model.saturation_exponent = 3.0;
  EXPECT_NEAR(motor_range(model, 0.0).greatest.torque_Nm,
              0.0756 * 40.0 / std::cbrt(1.0 + std::pow(40.0 / 30.0, 3)), 1e-12);
  for (const double q_A : {-35.0, -1.0, 0.0, 20.0, 40.0}) {
    EXPECT_NEAR(q_current_A(model, torque_Nm(model, {0.0, q_A}), 0.0), q_A, 1e-10);
  }
}

// Oracle: R i + K w + V_dead = V at the bound, for a current that drives.
TEST(MotorRange, LosesTheDeadTimesVoltage) {
  Actuator actuator = round_actuator();
  actuator.effects.push_back(effect("inverter_dead_time", {2.0}));
  const MotorRange range = motor_range(phase_model_at(actuator, {}), 80.0);
  EXPECT_NEAR(range.greatest.torque_Nm, 0.5 * (50.0 - 2.0 - 40.0) / 0.5, 1e-10);
  // At full voltage the bus delivers V i, bridge included.
  EXPECT_NEAR(range.greatest.bus_power_W, 50.0 * 16.0, 1e-9);
}

}  // namespace
}  // namespace torquewright::actuator
