// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/named_things.hpp"

#include <fmt/format.h>

#include "robot/find_name.hpp"

namespace torquewright::hopper {
namespace {

/// The key under which a range names them: "body" stands in a list of "bodies".
std::string list_key_of(const NamedThings& things) {
  return things.what == "body" ? "bodies" : things.what + "s";
}

}  // namespace

std::vector<std::string> drive_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    names.insert(names.end(), drivetrain.actuator_names.begin(), drivetrain.actuator_names.end());
  }
  return names;
}

NamedThings drawing_bodies(const Robot& robot) {
  NamedThings things{"body", {}, {}};
  for (const dynamics::Body& body : robot.tree.bodies) {
    things.names.push_back(body.name);
    things.objections.emplace_back(body.inertia.mass_kg > 0.0 ? "" : "has no mass");
  }
  return things;
}

NamedThings drawing_drives(const Robot& robot) {
  NamedThings things{"drive", drive_names(robot), {}};
  things.objections.resize(things.names.size());
  return things;
}

NamedThings drawing_joints(const Robot& robot) {
  NamedThings things{"joint", {}, {}};
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    const dynamics::Joint& joint = robot.tree.bodies[i].joint;
    const bool turns = joint.kind == dynamics::JointKind::kRevolute;
    things.names.push_back(joint.name);
    things.objections.emplace_back(turns ? "" : "slides; offsets are in rad");
  }
  return things;
}

std::vector<std::size_t> meant_by(const NamedRange& range, const NamedThings& things,
                                  const std::string& file, std::vector<io::Fault>& faults) {
  std::vector<std::size_t> meant;
  if (range.names.empty()) {
    for (std::size_t i = 0; i < things.names.size(); ++i) {
      if (things.objections[i].empty()) meant.push_back(i);
    }
    return meant;
  }
  for (std::size_t i = 0; i < range.names.size(); ++i) {
    const io::Fault place{file, fmt::format("{}/{}/{}", range.path, list_key_of(things), i), ""};
    const auto found = find_name(things.names, range.names[i], things.what, place, faults);
    if (!found) continue;
    if (things.objections[*found].empty()) {
      meant.push_back(*found);
    } else {
      faults.push_back({place.file, place.path,
                        fmt::format("\"{}\" {}", range.names[i], things.objections[*found])});
    }
  }
  return meant;
}

}  // namespace torquewright::hopper
