// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/effects/library.hpp"
#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// Round numbers without losses: Kt 0.5 Nm/A, R 0.5 ohm, 50 V, 40 A, ratio 10, all `dc`.
/// No load 100 rad/s at the rotor, corner (50 - 20)/0.5 = 60, overspeed (50 + 20)/0.5 = 140.
inline Actuator round_actuator() {
  Actuator actuator;
  actuator.motor.torque_constant_Nm_A = 0.5;
  actuator.motor.resistance_ohm = 0.5;
  actuator.drive.bus_voltage_V = 50.0;
  actuator.drive.peak_current_A = 40.0;
  actuator.transmission.ratio = 10.0;
  return actuator;
}

inline Effect effect(const char* name, std::vector<double> values) {
  return {find_effect(name), std::move(values), {}, false, "test"};
}

inline Effect harmonics(const char* name, std::vector<Harmonic> waves, bool proportional = false) {
  return {find_effect(name), {}, std::move(waves), proportional, "test"};
}

}  // namespace torquewright::actuator
