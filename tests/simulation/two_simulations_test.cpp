// SPDX-License-Identifier: Apache-2.0
// Oracle: an independent simulation, written from the contract's table without the effects' code
// (tests/oracles/bench_log). The same truth under the same excitation, effect by effect.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/oracles/bench_log/plant.hpp"
#include "tests/simulation/simple_drive.hpp"

namespace torquewright::simulation {
namespace {

using oracles::Machine;

enum class Compare { kPosition, kTorque, kCurrent, kBus, kTwist };

struct Comparison {
  const char* name;
  Load load;
  DriveKind drive;
  Compare compare;
  double bound;  ///< Rms of the difference over rms of the quantity.
  std::function<void(Machine&)> truth;
  std::vector<actuator::Effect> effects;
};

// No integration: the same formula twice.
constexpr double kFormula = 1e-12;
// Both have errors of second order in steps of 0.1 to 0.25 ms, stops and starts included: some
// (h w)^2 / 24 = 1e-6 for motions of up to 11 rad/s.
constexpr double kMotion = 1e-5;
// The other one takes the back-EMF of a step's start, half a step of 0.1 ms late: at 11 rad/s 6e-4.
constexpr double kFirstOrder = 1e-3;
// The other one's two inertias move by a scheme of first order in steps of 0.05 ms, and the twist
// keeps its phase over 300 rad.
constexpr double kTwist = 5e-3;
// Flanks meet at frequencies that each simulation chose for itself (800 and 1000 rad/s).
constexpr double kContact = 5e-2;

Machine like_simple(Load load) {
  Machine machine;
  machine.ratio = 10.0;
  machine.torque_constant_Nm_A = 0.1;
  machine.resistance_ohm = 0.5;
  machine.rotor_inertia_kg_m2 = 1e-4;
  machine.bus_V = 48.0;
  machine.peak_current_A = 1000.0;
  machine.winding_J_K = machine.case_J_K = 1e12;  // temperatures stay
  if (load == Load::kPendulum) {
    machine.load.type = oracles::Load::Type::kPendulum;
    machine.load.inertia_kg_m2 = 0.02 + 0.09;
    machine.load.gravity_Nm = 9.81 * 0.3;
  }
  if (load == Load::kFree) {
    machine.load.type = oracles::Load::Type::kFree;
    machine.load.inertia_kg_m2 = 0.02;
  }
  return machine;
}

double drive_value(DriveKind kind, double t) {
  const double shape = std::sin(2.0 * t) + 0.7 * std::sin(5.3 * t + 1.0) + 0.3 * std::sin(11.0 * t);
  return kind == DriveKind::kVoltage ? 2.0 * shape : 0.8 * shape;
}

/// Both traces name their quantities alike.
template <typename Trace>
std::vector<double> compared(const Trace& trace, Compare what) {
  switch (what) {
    case Compare::kPosition:
      return trace.position_rad;
    case Compare::kTorque:
      return trace.torque_Nm;
    case Compare::kCurrent:
      return trace.current_A;
    case Compare::kBus:
      return trace.bus_V;
    case Compare::kTwist:
      break;
  }
  std::vector<double> twist;
  for (std::size_t i = 0; i < trace.position_rad.size(); ++i) {
    twist.push_back(trace.motor_position_rad[i] / 10.0 - trace.position_rad[i]);
  }
  return twist;
}

class TwoSimulations : public testing::TestWithParam<Comparison> {};

TEST_P(TwoSimulations, Agree) {
  const Comparison& the = GetParam();
  constexpr double kWinding_K = 340.0;
  Excitation excited = excitation(
      4.0, oracles::kTick_s, [&](double t) { return drive_value(the.drive, t); }, the.drive);
  for (const double t : excited.time_s) {
    excited.joints[0].speed_rad_s.push_back(3.0 * std::sin(1.7 * t) + 1.0 * std::sin(6.1 * t));
  }
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = the.effects;
  JointStart start;
  start.position_rad = 0.1;
  start.winding_K = start.case_K = kWinding_K;
  const SimulatedRun ours = run(the.load, actuator, excited, start);

  Machine machine = like_simple(the.load);
  the.truth(machine);
  oracles::RunPlan plan;
  plan.start_rad = 0.1;
  plan.winding_K = plan.case_K = kWinding_K;
  if (the.load == Load::kDynamometer) plan.speed_rad_s = excited.joints[0].speed_rad_s;
  (the.drive == DriveKind::kVoltage ? plan.voltage_V : plan.current_A) = excited.joints[0].value;
  const oracles::Trace theirs = oracles::simulate(machine, plan);

  const std::vector<double> a = compared(ours.joints[0], the.compare);
  const std::vector<double> b = compared(theirs, the.compare);
  ASSERT_EQ(a.size(), b.size());
  double difference = 0.0;
  double mean = 0.0;
  for (const double value : b) mean += value / static_cast<double>(b.size());
  double size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += (a[i] - b[i]) * (a[i] - b[i]);
    size += (b[i] - mean) * (b[i] - mean);
  }
  EXPECT_LT(std::sqrt(difference / size), the.bound);
  EXPECT_GT(size, 0.0);
}

const auto kPendulum = Load::kPendulum;
const auto kDynamometer = Load::kDynamometer;
const auto kCurrent = DriveKind::kCurrent;
const auto kVoltage = DriveKind::kVoltage;

oracles::Harmonics theirs(double order, double amplitude, double phase) {
  return {{{order, amplitude, phase}}};
}

std::vector<Comparison> cases() {
  return {
      {"nothing", kPendulum, kCurrent, Compare::kPosition, kMotion, [](Machine&) {}, {}},
      {"viscous",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) {
         m.friction.viscous_positive_Nm_s_rad = m.friction.viscous_negative_Nm_s_rad = 0.1;
       },
       {effect("viscous_friction", {0.1})}},
      {"coulomb",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) { m.friction.coulomb_positive_Nm = m.friction.coulomb_negative_Nm = 0.4; },
       {effect("coulomb_friction", {0.4})}},
      {"stribeck",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) {
         m.friction.coulomb_positive_Nm = m.friction.coulomb_negative_Nm = 0.3;
         m.friction.breakaway_excess_Nm = 0.3;
         m.friction.stribeck_velocity_rad_s = 0.5;
       },
       {effect("stribeck_friction", {0.3, 0.6, 0.5})}},
      {"asymmetric",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) {
         m.friction.coulomb_positive_Nm = 0.4;
         m.friction.coulomb_negative_Nm = 0.2;
         m.friction.viscous_positive_Nm_s_rad = 0.05;
         m.friction.viscous_negative_Nm_s_rad = 0.1;
       },
       {effect("asymmetric_friction", {0.4, 0.2, 0.05, 0.1})}},
      {"drag",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) { m.friction.drag_Nm_s2_rad2 = 0.1; },
       {effect("quadratic_drag", {0.1})}},
      {"load_friction",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) {
         m.driving_coefficient = 0.3;
         m.backdriving_coefficient = 0.2;
       },
       {effect("load_dependent_friction", {0.3, 0.2})}},
      {"load_friction_imposed",
       kDynamometer,
       kCurrent,
       Compare::kTorque,
       kFormula,
       [](Machine& m) {
         m.driving_coefficient = 0.3;
         m.backdriving_coefficient = 0.2;
       },
       {effect("load_dependent_friction", {0.3, 0.2})}},
      {"presliding",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kFirstOrder,
       [](Machine& m) {
         m.friction.coulomb_positive_Nm = m.friction.coulomb_negative_Nm = 0.5;
         m.friction.presliding_Nm_rad = 20.0;
       },
       {effect("presliding_friction", {0.5, 20.0})}},
      {"saturation",
       kDynamometer,
       kCurrent,
       Compare::kTorque,
       kFormula,
       [](Machine& m) {
         m.saturation_current_A = 2.0;
         m.saturation_exponent = 3.0;
       },
       {effect("torque_constant_saturation", {2.0, 3.0})}},
      {"kt_temperature",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) { m.torque_constant_1_K = -0.002; },
       {effect("torque_constant_temperature", {-0.002})}},
      {"kt_error",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) { m.torque_constant_factor = 0.8; },
       {effect("torque_constant_error", {0.8})}},
      {"kt_error_on_voltage",
       kPendulum,
       kVoltage,
       Compare::kPosition,
       kFirstOrder,
       [](Machine& m) { m.torque_constant_factor = 0.8; },
       {effect("torque_constant_error", {0.8})}},
      {"friction_temperature",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) {
         m.friction.coulomb_positive_Nm = m.friction.coulomb_negative_Nm = 0.5;
         m.friction.coefficient_1_K = -0.01;
       },
       {effect("coulomb_friction", {0.5}), effect("friction_temperature", {-0.01})}},
      {"cogging",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) { m.cogging = theirs(7.0, 0.2, 0.4); },
       {harmonic_effect("cogging_torque", {{7.0, 0.2, 0.4}})}},
      {"ripple",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) { m.ripple = theirs(5.0, 0.3, 0.2); },
       {harmonic_effect("gear_ripple", {{5.0, 0.3, 0.2}})}},
      {"load_ripple",
       kDynamometer,
       kCurrent,
       Compare::kTorque,
       kFormula,
       [](Machine& m) { m.load_ripple = theirs(5.0, 0.1, 0.2); },
       {harmonic_effect("gear_ripple", {{5.0, 0.1, 0.2}}, true)}},
      {"position_friction",
       kDynamometer,
       kCurrent,
       Compare::kTorque,
       kFormula,
       [](Machine& m) {
         m.friction.coulomb_positive_Nm = m.friction.coulomb_negative_Nm = 0.5;
         m.friction.over_position = theirs(1.0, 0.3, 0.2);
       },
       {effect("coulomb_friction", {0.5}),
        harmonic_effect("position_dependent_friction", {{1.0, 0.3, 0.2}})}},
      {"backlash",
       kDynamometer,
       kCurrent,
       Compare::kTwist,
       kContact,
       [](Machine& m) {
         m.gap_rad = 0.05;
         m.friction.viscous_positive_Nm_s_rad = m.friction.viscous_negative_Nm_s_rad = 1.0;
       },
       {effect("backlash", {0.05}), effect("viscous_friction", {1.0})}},
      {"compliance",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kTwist,
       [](Machine& m) {
         m.stiffness_Nm_rad = 50.0;
         m.damping_Nm_s_rad = 0.1;
       },
       {effect("torsional_compliance", {50.0, 0.1})}},
      {"compliance_imposed",
       kDynamometer,
       kCurrent,
       Compare::kTorque,
       kTwist,
       [](Machine& m) {
         m.stiffness_Nm_rad = 50.0;
         m.damping_Nm_s_rad = 0.1;
       },
       {effect("torsional_compliance", {50.0, 0.1})}},
      {"inertia",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) { m.extra_inertia_kg_m2 = 0.03; },
       {effect("reflected_inertia", {0.03})}},
      {"lag",
       kPendulum,
       kCurrent,
       Compare::kPosition,
       kMotion,
       [](Machine& m) { m.lag_s = 0.03; },
       {effect("torque_lag", {0.03})}},
      {"lag_imposed",
       kDynamometer,
       kCurrent,
       Compare::kTorque,
       kMotion,
       [](Machine& m) { m.lag_s = 0.03; },
       {effect("torque_lag", {0.03})}},
      {"resistance_temperature",
       kPendulum,
       kVoltage,
       Compare::kCurrent,
       kFirstOrder,
       [](Machine& m) { m.resistance_1_K = 0.006; },
       {effect("winding_resistance_temperature", {0.006})}},
      {"dead_time",
       kPendulum,
       kVoltage,
       Compare::kPosition,
       kFirstOrder,
       [](Machine& m) { m.dead_time_V = 0.5; },
       {effect("inverter_dead_time", {0.5})}},
      {"sag",
       kPendulum,
       kVoltage,
       Compare::kBus,
       kFirstOrder,
       [](Machine& m) { m.sag_ohm = 0.2; },
       {effect("voltage_sag", {0.2})}},
  };
}

INSTANTIATE_TEST_SUITE_P(EachEffect, TwoSimulations, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Comparison>& of) {
                           return of.param.name;
                         });

}  // namespace
}  // namespace torquewright::simulation
