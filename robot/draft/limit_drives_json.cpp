// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "actuator/motor/actuator_spec.hpp"
#include "io/documents/json_layout.hpp"
#include "io/faults/json_text.hpp"
#include "robot/draft/limit_drives.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::ordered_json;

struct Limits {
  double torque_Nm;    ///< Of a slide in N,
  double speed_rad_s;  ///< and in m/s.
  bool pushes;
  double coulomb_Nm = 0.0, viscous_Nm_s_rad = 0.0;
  friend bool operator==(const Limits&, const Limits&) = default;
};

bool is_driven(const Robot& robot, std::size_t body) {
  return std::any_of(robot.drivetrains.begin(), robot.drivetrains.end(), [&](const auto& train) {
    return std::find(train.joints.begin(), train.joints.end(), body) != train.joints.end();
  });
}

bool is_stated(double limit) { return std::isfinite(limit) && limit > 0.0; }

/// Beyond any joint; what the document's schema allows.
constexpr double kAnySpeed_rad_s = 1e5;

Limits limits_of(const dynamics::JointLimits& stated, bool pushes) {
  return {stated.effort_max, is_stated(stated.speed_max) ? stated.speed_max : kAnySpeed_rad_s,
          pushes};
}

std::string name_of(const Limits& limits) {
  const char* torque = limits.pushes ? "N" : "Nm";
  if (limits.speed_rad_s == kAnySpeed_rad_s) {
    return fmt::format("{:g} {} at any speed", limits.torque_Nm, torque);
  }
  return fmt::format("{:g} {} up to {:g} {}", limits.torque_Nm, torque, limits.speed_rad_s,
                     limits.pushes ? "m/s" : "rad/s");
}

std::string file_of(const Limits& limits) {
  const char* torque = limits.pushes ? "N" : "Nm";
  if (limits.speed_rad_s == kAnySpeed_rad_s) {
    return fmt::format("drive_{:g}{}.json", limits.torque_Nm, torque);
  }
  return fmt::format("drive_{:g}{}_{:g}{}.json", limits.torque_Nm, torque, limits.speed_rad_s,
                     limits.pushes ? "m_s" : "rad_s");
}

void add_effect(const char* effect, const char* parameter, double value, ordered_json& document) {
  if (value == 0.0) return;
  document["effects"].push_back(
      {{"effect", effect}, {"parameters", {{parameter, value}}}, {"provenance", "imported"}});
}

std::string document_of(const Limits& limits) {
  ordered_json document{{"kind", "actuator"},
                        {"version", 1},
                        {"name", name_of(limits)},
                        {"envelope",
                         {{"side", "joint"},
                          {"losses", "apart"},
                          {"peak_torque_Nm", limits.torque_Nm},
                          {"maximum_speed_rad_s", limits.speed_rad_s}}}};
  add_effect("coulomb_friction", "coulomb_Nm", limits.coulomb_Nm, document);
  add_effect("viscous_friction", "viscous_Nm_s_rad", limits.viscous_Nm_s_rad, document);
  return io::json_layout(document);
}

/// Alike limits share a drive.
class Shelf {
 public:
  explicit Shelf(LimitDrives& made) : made_(made) {}

  std::size_t drive_of(const Limits& limits) {
    const auto place =
        static_cast<std::size_t>(std::find(known_.begin(), known_.end(), limits) - known_.begin());
    if (place == known_.size()) {
      known_.push_back(limits);
      made_.drives.push_back({free_file(file_of(limits)), document_of(limits)});
    }
    return place;
  }

 private:
  /// Alike limits may have other drag.
  std::string free_file(const std::string& file) const {
    const std::string stem = file.substr(0, file.rfind(".json"));
    std::string name = file;
    const auto is_taken = [&](const auto& drive) { return drive.file == name; };
    for (int number = 2; std::any_of(made_.drives.begin(), made_.drives.end(), is_taken);
         ++number) {
      name = fmt::format("{}_{}.json", stem, number);
    }
    return name;
  }

  LimitDrives& made_;
  std::vector<Limits> known_;
};

void note(const char* why, const std::vector<std::string>& joints, LimitDrives& made) {
  if (joints.empty()) return;
  made.notes.push_back(fmt::format("no drive is made for {} joint{} without {}: {}", joints.size(),
                                   joints.size() == 1 ? "" : "s", why, fmt::join(joints, ", ")));
}

}  // namespace

LimitDrives limit_drives(const Robot& robot,
                         const std::map<std::string, StatedDrive>& loop_drives) {
  LimitDrives made;
  Shelf shelf(made);
  std::vector<std::string> without_torque, without_speed, slides;
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    const dynamics::Joint& joint = robot.tree.bodies[body].joint;
    if (is_driven(robot, body)) continue;
    if (!is_stated(joint.limits.effort_max)) {
      without_torque.push_back(joint.name);
      continue;
    }
    const bool pushes = joint.kind == dynamics::JointKind::kPrismatic;
    if (pushes) slides.push_back(joint.name);
    if (!is_stated(joint.limits.speed_max)) without_speed.push_back(joint.name);
    made.assignments.push_back({joint.name, shelf.drive_of(limits_of(joint.limits, pushes))});
  }
  for (std::size_t i = 0; i < robot.drivetrains.size(); ++i) {
    const Drivetrain& drivetrain = robot.drivetrains[i];
    for (std::size_t j = 0; j < drivetrain.actuator_files.size(); ++j) {
      if (!drivetrain.actuator_files[j].empty()) continue;
      const std::string& name = drivetrain.actuator_names[j];
      const auto stated = loop_drives.find(name);
      if (stated == loop_drives.end() || !is_stated(stated->second.limits.effort_max)) {
        made.unlimited.push_back(name);
        continue;
      }
      const StatedDrive& drive = stated->second;
      if (drive.pushes) slides.push_back(name);
      if (!is_stated(drive.limits.speed_max)) without_speed.push_back(name);
      Limits limits = limits_of(drive.limits, drive.pushes);
      limits.coulomb_Nm = drive.coulomb_Nm;
      limits.viscous_Nm_s_rad = drive.viscous_Nm_s_rad;
      made.in_loops.push_back({i, j, shelf.drive_of(limits)});
    }
  }
  note("a limit of torque", without_torque, made);
  if (!without_speed.empty()) {
    made.notes.push_back(fmt::format(
        "drives of joints that state no limit of speed have their torque at any speed: {}",
        fmt::join(without_speed, ", ")));
  }
  if (!slides.empty()) {
    made.notes.push_back(fmt::format(
        "the documents of drives that push ({}) state forces in N as torques, and speeds in m/s",
        fmt::join(slides, ", ")));
  }
  return made;
}

void drive_by_limits(Robot& robot) {
  const LimitDrives made = limit_drives(robot);
  for (const LimitDrives::Assignment& one : made.assignments) {
    const LimitDrives::Drive& drive = made.drives[one.drive];
    Drivetrain drivetrain;
    drivetrain.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
    drivetrain.joints = {*robot.find_joint(one.joint)};
    drivetrain.actuators.push_back(
        actuator::read_actuator(
            io::check_document(nlohmann::json::parse(drive.document), "actuator", drive.file, ""))
            .actuator);
    drivetrain.actuator_names = {one.joint};
    drivetrain.actuator_files = {drive.file};
    drivetrain.on_robots_battery = {false};
    drivetrain.joints_state_rotors = true;
    drivetrain.is_of_limits = true;
    robot.drivetrains.push_back(std::move(drivetrain));
  }
}

std::string with_limit_drives(const LimitDrives& made, const std::string& folder,
                              const std::string& robot) {
  ordered_json document = ordered_json::parse(robot);
  for (const LimitDrives::LoopAssignment& one : made.in_loops) {
    const std::string& file = made.drives[one.drive].file;
    document["mechanisms"][one.mechanism]["actuators"][one.actuator] =
        folder.empty() ? file : folder + "/" + file;
  }
  for (const LimitDrives::Assignment& one : made.assignments) {
    const std::string& file = made.drives[one.drive].file;
    document["mechanisms"].push_back(
        {{"type", "direct"},
         {"joints", {one.joint}},
         {"actuators", {folder.empty() ? file : folder + "/" + file}}});
  }
  return io::json_text(document);
}

}  // namespace torquewright::hopper
