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
  double torque_Nm;
  double speed_rad_s;
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

std::string name_of(const Limits& limits) {
  if (limits.speed_rad_s == kAnySpeed_rad_s) {
    return fmt::format("{:g} Nm at any speed", limits.torque_Nm);
  }
  return fmt::format("{:g} Nm up to {:g} rad/s", limits.torque_Nm, limits.speed_rad_s);
}

std::string file_of(const Limits& limits) {
  if (limits.speed_rad_s == kAnySpeed_rad_s) {
    return fmt::format("drive_{:g}Nm.json", limits.torque_Nm);
  }
  return fmt::format("drive_{:g}Nm_{:g}rad_s.json", limits.torque_Nm, limits.speed_rad_s);
}

std::string document_of(const Limits& limits) {
  const ordered_json document{{"kind", "actuator"},
                              {"version", 1},
                              {"name", name_of(limits)},
                              {"envelope",
                               {{"side", "joint"},
                                {"losses", "apart"},
                                {"peak_torque_Nm", limits.torque_Nm},
                                {"maximum_speed_rad_s", limits.speed_rad_s}}}};
  return io::json_layout(document);
}

void note(const char* why, const std::vector<std::string>& joints, LimitDrives& made) {
  if (joints.empty()) return;
  made.notes.push_back(fmt::format("no drive is made for {} joint{} that {}: {}", joints.size(),
                                   joints.size() == 1 ? "" : "s", why, fmt::join(joints, ", ")));
}

}  // namespace

LimitDrives limit_drives(const Robot& robot) {
  LimitDrives made;
  std::vector<Limits> known;
  std::vector<std::string> slides, without_torque, without_speed;
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    const dynamics::Joint& joint = robot.tree.bodies[body].joint;
    if (is_driven(robot, body)) continue;
    const bool has_speed = is_stated(joint.limits.speed_max);
    const Limits limits{joint.limits.effort_max,
                        has_speed ? joint.limits.speed_max : kAnySpeed_rad_s};
    if (joint.kind != dynamics::JointKind::kRevolute) {
      slides.push_back(joint.name);
    } else if (!is_stated(limits.torque_Nm)) {
      without_torque.push_back(joint.name);
    } else {
      if (!has_speed) without_speed.push_back(joint.name);
      const auto place =
          static_cast<std::size_t>(std::find(known.begin(), known.end(), limits) - known.begin());
      if (place == known.size()) {
        known.push_back(limits);
        made.drives.push_back({file_of(limits), document_of(limits)});
      }
      made.assignments.push_back({joint.name, place});
    }
  }
  note("slide", slides, made);
  note("state no limit of torque", without_torque, made);
  if (!without_speed.empty()) {
    made.notes.push_back(
        fmt::format("the drives of {} joints that state no limit of speed have "
                    "their torque at any: {}",
                    without_speed.size(), fmt::join(without_speed, ", ")));
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
