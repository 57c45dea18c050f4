// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <random>

#include "actuator/effects/library.hpp"
#include "actuator/exporters/exporter.hpp"
#include "actuator/motor/actuator_spec.hpp"

namespace torquewright::actuator {

/// An actuator with its region and table, from which subjects of either fit are made.
struct Example {
  explicit Example(Actuator of, Side side = Side::kJoint)
      : actuator(std::move(of)), region(actuator, conditions, side), table(mor_table(region)) {}

  Subject subject(LawFit fit) const { return {actuator, conditions, region, table, fit}; }

  Actuator actuator;
  OperatingConditions conditions;
  Region region;
  MorTable table;
};

/// specs/actuator/d151_knee.json: no losses, so that its region is the parallelogram with stall
/// torque 20 0.32 67.2 / 0.28 = 1536 Nm, no-load speed 67.2 / (20 0.32) = 10.5 rad/s and greatest
/// torque 20 0.32 50 = 320 Nm; corner 8.3125 rad/s, overspeed 12.6875 rad/s.
inline Actuator knee() {
  return read_actuator(std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) /
                       "specs/actuator/d151_knee.json")
      .actuator;
}

inline Effect effect(std::string_view name, std::vector<double> values) {
  Effect made = neutral(*find_effect(name));
  made.values = std::move(values);
  return made;
}

/// The knee with gear losses, friction and saturation, turned backwards by its gearbox: bounds jump
/// at rest and no parallelogram fits.
inline Actuator lossy_knee() {
  Actuator actuator = knee();
  actuator.name = "lossy knee";
  actuator.transmission.ratio = -20.0;
  actuator.transmission.forward_efficiency = 0.9;
  actuator.transmission.backward_efficiency = 0.88;
  actuator.effects = {effect("coulomb_friction", {6.0}), effect("viscous_friction", {1.5}),
                      effect("torque_constant_saturation", {60.0, 2.0})};
  return actuator;
}

/// The knee's motor behind 6:1 on 48 V and 20 A, with friction that depends on no load. By hand:
/// 0.32 6 20 = 38.4 Nm, stall 0.32 6 48 / 0.28 = 329.14 Nm, no load 48 / (0.32 6) = 25 rad/s.
inline Actuator dry_drive() {
  Actuator actuator = knee();
  actuator.name = "dry drive";
  actuator.motor.rotor_inertia_kg_m2 = 1e-4;
  actuator.drive.bus_voltage_V = 48.0;
  actuator.drive.peak_current_A = 20.0;
  actuator.transmission = {};
  actuator.transmission.ratio = 6.0;
  actuator.effects = {effect("coulomb_friction", {0.4}), effect("viscous_friction", {0.02})};
  return actuator;
}

/// The same with losses in proportion to load, each way its own.
inline Actuator loaded_drive() {
  Actuator actuator = dry_drive();
  actuator.name = "loaded drive";
  actuator.transmission.forward_efficiency = 0.9;
  actuator.transmission.backward_efficiency = 0.85;
  actuator.effects.push_back(effect("load_dependent_friction", {0.03, 0.04}));
  return actuator;
}

/// Of no particular kind: losses, friction, saturation and voltage at random.
inline Actuator random_actuator(std::mt19937& dice) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(dice);
  };
  Actuator actuator = knee();
  actuator.name = "random";
  actuator.motor.resistance_ohm = between(0.1, 1.5);
  actuator.drive.bus_voltage_V = between(30.0, 80.0);
  actuator.drive.field_weakening = between(0.0, 1.0) < 0.5;
  actuator.motor.inductance_d_H = between(0.0, 3e-4);
  actuator.motor.inductance_q_H = actuator.motor.inductance_d_H;
  actuator.transmission.forward_efficiency = between(0.7, 1.0);
  actuator.transmission.backward_efficiency = between(0.6, 1.0);
  actuator.effects = {effect("coulomb_friction", {between(0.0, 15.0)}),
                      effect("viscous_friction", {between(0.0, 3.0)}),
                      effect("torque_constant_saturation", {between(30.0, 100.0), 2.0})};
  return actuator;
}

}  // namespace torquewright::actuator
