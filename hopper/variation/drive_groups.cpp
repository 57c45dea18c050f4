// SPDX-License-Identifier: Apache-2.0
#include "hopper/variation/drive_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

/// "ankle" of ankle_left and ankle_right; empty where they share no whole word.
std::string shared_words(const std::vector<std::string>& names) {
  std::string shared = names.front();
  for (const std::string& name : names) {
    const auto end = std::mismatch(shared.begin(), shared.end(), name.begin(), name.end()).first;
    shared.erase(end, shared.end());
  }
  const std::size_t underscore = shared.rfind('_');
  return underscore == std::string::npos ? "" : shared.substr(0, underscore);
}

template <typename AnyRobot>
auto& find_drive(AnyRobot& robot, std::size_t drive) {
  for (auto& drivetrain : robot.drivetrains) {
    if (drive < drivetrain.actuators.size()) return drivetrain.actuators[drive];
    drive -= drivetrain.actuators.size();
  }
  throw std::out_of_range("drive_at: there is no such drive");
}

}  // namespace

std::vector<DriveGroup> drive_groups(const Robot& robot) {
  std::vector<DriveGroup> groups;
  std::size_t drive = 0;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    const std::size_t first = drive;
    for (const std::string& name : drivetrain.actuator_names) groups.push_back({name, {drive++}});
    if (drivetrain.actuator_names.size() < 2) continue;
    DriveGroup all{shared_words(drivetrain.actuator_names), {}};
    for (std::size_t i = first; i < drive; ++i) all.drives.push_back(i);
    if (!all.name.empty()) groups.push_back(std::move(all));
  }
  std::vector<DriveGroup> clear;
  for (const DriveGroup& group : groups) {
    const auto same = std::count_if(groups.begin(), groups.end(), [&](const DriveGroup& other) {
      return other.name == group.name;
    });
    if (same == 1) clear.push_back(group);
  }
  return clear;
}

std::optional<std::vector<std::size_t>> drives_named(const Robot& robot, const std::string& name) {
  for (const DriveGroup& group : drive_groups(robot)) {
    if (group.name == name) return group.drives;
  }
  return std::nullopt;
}

std::vector<std::size_t> every_drive(const Robot& robot) {
  std::vector<std::size_t> drives(every_drive_name(robot).size());
  std::iota(drives.begin(), drives.end(), std::size_t{0});
  return drives;
}

std::vector<std::string> every_drive_name(const Robot& robot) {
  std::vector<std::string> names;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    names.insert(names.end(), drivetrain.actuator_names.begin(), drivetrain.actuator_names.end());
  }
  return names;
}

const actuator::Actuator& drive_at(const Robot& robot, std::size_t drive) {
  return find_drive(robot, drive);
}

actuator::Actuator& drive_at(Robot& robot, std::size_t drive) { return find_drive(robot, drive); }

void refuse_name(const std::string& place, const std::string& name,
                 const std::vector<std::string>& known, std::string_view ending) {
  const auto close = io::nearest(name, known);
  io::refuse(place, fmt::format("\"{}\" is nothing that could be swept{}; there are {}, each with "
                                "{} behind it too",
                                name, close ? fmt::format("; did you mean \"{}\"?", *close) : "",
                                io::listed(known), ending));
}

}  // namespace torquewright::hopper
