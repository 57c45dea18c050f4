// SPDX-License-Identifier: Apache-2.0
#include "tests/actuator/random_actuator.hpp"

#include <cmath>
#include <random>

#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution(low, high)(random_);
  }
  double of_magnitude(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  bool says_yes(double share = 0.5) { return std::bernoulli_distribution(share)(random_); }
  int one_of(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }

 private:
  std::mt19937 random_;
};

void choose_motor(Dice& dice, const RandomActuatorOptions& options, Actuator& actuator) {
  Motor& motor = actuator.motor;
  motor.torque_constant_convention = static_cast<CurrentConvention>(dice.one_of(3));
  motor.resistance_convention = static_cast<ResistanceConvention>(dice.one_of(3));
  actuator.drive.modulation = static_cast<Modulation>(dice.one_of(3));
  actuator.drive.bus_voltage_V = dice.between(12.0, 80.0);
  motor.torque_constant_Nm_A = dice.of_magnitude(0.01, 0.5);
  motor.pole_pairs = 1 + dice.one_of(24);
  const double stall_A = dice.of_magnitude(30.0, 300.0);
  motor.resistance_ohm = actuator.drive.bus_voltage_V / stall_A;
  actuator.drive.peak_current_A = stall_A * dice.between(0.1, 1.2);
  actuator.drive.field_weakening = options.field_weakening;
  const double no_load_rad_s = actuator.drive.bus_voltage_V / motor.torque_constant_Nm_A;
  if (options.field_weakening || dice.says_yes()) {
    // Reactance at no load comparable with the resistance.
    motor.inductance_d_H = motor.inductance_q_H =
        dice.of_magnitude(0.1, 3.0) * motor.resistance_ohm / (motor.pole_pairs * no_load_rad_s);
  }
}

void choose_supply(Dice& dice, const RandomActuatorOptions& options, Actuator& actuator) {
  if (options.regeneration_limits && dice.says_yes(0.2)) actuator.drive.regeneration = false;
  if (dice.says_yes(0.4)) return;
  Battery battery;
  battery.series_cells = 1.0;
  battery.cell_open_circuit = {{1.0, actuator.drive.bus_voltage_V}};
  battery.cell_resistance_ohm = dice.between(0.0, 0.2) * actuator.motor.resistance_ohm;
  if (dice.says_yes(0.3)) {
    battery.discharge_limit_A = dice.between(0.3, 1.0) * actuator.drive.peak_current_A;
  }
  if (options.regeneration_limits && dice.says_yes(0.3)) {
    battery.charge_limit_A = dice.between(0.05, 1.0) * actuator.drive.peak_current_A;
  }
  actuator.battery = battery;
}

void choose_effects(Dice& dice, Actuator& actuator) {
  const Motor& motor = actuator.motor;
  const double ratio = std::abs(actuator.transmission.ratio);
  const double torque_Nm = ratio * motor.torque_constant_Nm_A * actuator.drive.peak_current_A;
  const double speed_rad_s = actuator.drive.bus_voltage_V / (motor.torque_constant_Nm_A * ratio);
  const auto maybe = [&](const char* name, std::vector<double> values) {
    if (dice.says_yes(0.3)) actuator.effects.push_back(effect(name, std::move(values)));
  };
  maybe("viscous_friction", {0.05 * torque_Nm / speed_rad_s});
  maybe("coulomb_friction", {0.03 * torque_Nm});
  maybe("stribeck_friction", {0.02 * torque_Nm, 0.04 * torque_Nm, 0.1 * speed_rad_s});
  maybe("quadratic_drag", {0.03 * torque_Nm / (speed_rad_s * speed_rad_s)});
  maybe("load_dependent_friction", {0.1, 0.08});
  maybe("torque_constant_saturation",
        {dice.between(0.5, 3.0) * actuator.drive.peak_current_A, 2.0});
  maybe("voltage_sag", {dice.between(0.0, 0.1) * motor.resistance_ohm});
  maybe("inverter_dead_time", {0.01 * actuator.drive.bus_voltage_V});
  maybe("asymmetric_friction", {0.01 * torque_Nm, 0.02 * torque_Nm, 0.0, 0.0});
  if (dice.says_yes(0.2)) {
    actuator.effects.push_back(harmonics("cogging_torque", {{6.0, 0.005 * torque_Nm, 0.1}}));
  }
  if (dice.says_yes(0.2)) {
    actuator.effects.push_back(harmonics("gear_ripple", {{2.0, 0.01, 0.0}}, true));
  }
}

}  // namespace

Actuator random_actuator(unsigned seed, const RandomActuatorOptions& options) {
  Dice dice(seed);
  Actuator actuator;
  choose_motor(dice, options, actuator);
  choose_supply(dice, options, actuator);
  actuator.transmission.ratio = dice.of_magnitude(1.0, 50.0) * (dice.says_yes(0.8) ? 1.0 : -1.0);
  actuator.transmission.forward_efficiency = dice.between(0.6, 1.0);
  actuator.transmission.backward_efficiency = dice.between(0.4, 1.0);
  if (options.with_effects) choose_effects(dice, actuator);
  return actuator;
}

}  // namespace torquewright::actuator
