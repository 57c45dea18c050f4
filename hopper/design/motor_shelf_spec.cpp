// SPDX-License-Identifier: Apache-2.0
#include "hopper/design/motor_shelf_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/text/one_line.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;

bool has_gears(const Actuator& actuator) {
  actuator::Transmission none;
  none.ratio = actuator.transmission.ratio;
  return actuator.transmission != none || std::abs(none.ratio) != 1.0;
}

/// Empty: it can be put behind other gears.
std::string objection(const Actuator& actuator) {
  if (actuator.envelope) {
    return "is known by a curve at its joint; no motor is known that other gears could be put on";
  }
  for (const actuator::Statement& statement : actuator.statements) {
    if (statement.at_joint.value_or(false) && statement.pointer.starts_with("/motor/")) {
      return fmt::format(
          "states {} at the joint of its own gears, whose losses are in it; state it at the motor",
          statement.pointer);
    }
  }
  return "";
}

std::optional<double> motor_mass_kg(const std::string& stem, const Actuator& actuator,
                                    const std::vector<io::Document>& documents) {
  for (const io::Document& document : documents) {
    if (document.root.value("kind", "") != "actuator") continue;
    if (io::stem_in_text(std::filesystem::path(document.file)) != stem) continue;
    const nlohmann::json& motor = document.root["motor"];
    if (motor.contains("mass_kg")) return motor["mass_kg"].get<double>();
  }
  return has_gears(actuator) ? std::nullopt : actuator.mass_kg;
}

void add(std::string name, Actuator actuator, MotorShelf& shelf) {
  if (const std::string why = objection(actuator); !why.empty()) {
    shelf.left_out.push_back(fmt::format("{}: {}", name, why));
    return;
  }
  const std::optional<double> mass_kg = motor_mass_kg(name, actuator, shelf.documents);
  shelf.motors.push_back({std::move(name), std::move(actuator), mass_kg});
}

}  // namespace

MotorShelf motor_shelf(actuator::DriveSet drives) {
  MotorShelf shelf{{}, std::move(drives.documents), std::move(drives.left_out)};
  for (actuator::NamedActuator& drive : drives.drives) {
    add(std::move(drive.stem), std::move(drive.actuator), shelf);
  }
  return shelf;
}

MotorShelf own_motor(const ReadRobot& robot, std::size_t drivetrain) {
  const Drivetrain& drive = robot.robot.drivetrains[drivetrain];
  MotorShelf shelf{{}, robot.documents, {}};
  for (io::Document& document : shelf.documents) {
    // The robot's battery, which its reader gives to drives that state none.
    if (drive.on_robots_battery.front()) document.root.erase("battery");
  }
  add(io::stem_in_text(std::filesystem::path(drive.actuator_files.front())),
      drive.actuators.front(), shelf);
  return shelf;
}

}  // namespace torquewright::hopper
