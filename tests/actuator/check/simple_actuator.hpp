// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"

namespace torquewright::test {

/// A dc motor at 48 V: 0.1 Nm/A, 0.5 ohm, 30 A, 10:1 without losses. At the joint: stall (were it
/// not for the current) 96 Nm, cap 30 Nm, no-load 48 rad/s, corner 33 rad/s, N^2 J = 0.01 kg m^2.
inline actuator::Actuator simple_actuator() {
  actuator::Actuator actuator;
  actuator.name = "simple";
  actuator.motor.torque_constant_Nm_A = 0.1;
  actuator.motor.resistance_ohm = 0.5;
  actuator.motor.rotor_inertia_kg_m2 = 1e-4;
  actuator.drive.bus_voltage_V = 48.0;
  actuator.drive.peak_current_A = 30.0;
  actuator.transmission.ratio = 10.0;
  return actuator;
}

}  // namespace torquewright::test
