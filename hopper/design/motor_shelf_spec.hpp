// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/catalogue/drive_set.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {

/// A motor with its drive, to be put behind gears that are yet to be chosen.
struct ShelfMotor {
  std::string name;
  actuator::Actuator actuator;    ///< Its own transmission says nothing any more.
  std::optional<double> mass_kg;  ///< Of the motor without gears, where that is known.
};

struct MotorShelf {
  std::vector<ShelfMotor> motors;
  std::vector<io::Document> documents;
  std::vector<std::string> left_out;  ///< Sentences: what is no motor by itself, and why.
};

/// The motors of some drives. A motor weighs what `motor/mass_kg` states, or, without gears of its
/// own, what the document states of all of it. Left out are drives that are known by a curve at
/// their joint, and motors whose constants were measured behind their own gears.
MotorShelf motor_shelf(actuator::DriveSet drives);

/// The motor that a robot has in a drivetrain now.
MotorShelf own_motor(const ReadRobot& robot, std::size_t drivetrain);

}  // namespace torquewright::hopper
