// SPDX-License-Identifier: Apache-2.0
#include "robot/simulators/actuator_file.hpp"

#include <fmt/format.h>

#include "robot/simulators/drive_entries.hpp"

namespace torquewright::hopper {

Exported actuators_of(const Robot& robot, const actuator::Exporter& exporter,
                      const std::vector<std::string>& origin, actuator::FrictionPlace friction) {
  DriveEntries drives = drive_entries(robot, exporter, friction);
  note_own_forces(robot, friction, drives.notes);
  std::vector<std::string> head = origin;
  head.push_back(fmt::format("{}: every drive, for {}.", robot.name, exporter.simulator));
  head.insert(head.end(), drives.notes.begin(), drives.notes.end());
  const std::vector<std::string> own = actuator_lines(drives);
  head.insert(head.end(), own.begin(), own.end());
  return {exporter.write_all(drives.entries, head), std::move(drives.notes)};
}

}  // namespace torquewright::hopper
