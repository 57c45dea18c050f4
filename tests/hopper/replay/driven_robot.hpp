// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/model/robot.hpp"
#include "tests/actuator/example_actuator.hpp"

namespace torquewright::hopper {

/// Actuators that each turn a joint, without bodies: what drives alone need of a robot.
inline Robot driven_robot(const std::vector<actuator::Actuator>& actuators) {
  Robot robot;
  for (const actuator::Actuator& actuator : actuators) {
    Drivetrain drivetrain;
    drivetrain.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
    drivetrain.joints = {robot.drivetrains.size() + 1};
    drivetrain.actuators = {actuator};
    drivetrain.actuator_names = {"drive_" + std::to_string(drivetrain.joints[0])};
    robot.drivetrains.push_back(drivetrain);
  }
  return robot;
}

/// 50 V behind a resistance.
inline actuator::Battery battery(double resistance_ohm) {
  actuator::Battery battery;
  battery.cell_open_circuit = {{1.0, 50.0}};
  battery.cell_resistance_ohm = resistance_ohm;
  return battery;
}

/// Behind a ratio of 10: 5 Nm/A at the output, 200 Nm at 40 A, no load at 10 rad/s, and on a held
/// bus 10 V - 50 w Nm where the voltage limits.
inline actuator::Actuator round_drive(double resistance_ohm) {
  actuator::Actuator actuator = actuator::round_actuator();
  actuator.battery = battery(resistance_ohm);
  return actuator;
}

}  // namespace torquewright::hopper
