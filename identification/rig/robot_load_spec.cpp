// SPDX-License-Identifier: Apache-2.0
#include "identification/rig/robot_load_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::identification {
namespace {

using Report = std::function<void(const std::string&, std::string)>;

/// What moves is bodies on joints alone: the rest is the drives'.
dynamics::Tree bare_tree(dynamics::Tree tree) {
  tree.base = dynamics::BaseKind::kFixed;
  for (dynamics::Body& body : tree.bodies) {
    body.joint.passive = {};
    body.joint.reflected_inertia = 0.0;
    body.joint.rotor_spin_kg_m2.setZero();
  }
  return tree;
}

std::vector<std::string> joint_names(const dynamics::Tree& tree) {
  std::vector<std::string> names;
  for (std::size_t body = 1; body < tree.bodies.size(); ++body) {
    names.push_back(tree.bodies[body].joint.name);
  }
  return names;
}

std::string unknown_joint(const std::string& name, const std::vector<std::string>& known) {
  const auto near = io::nearest(name, known);
  return fmt::format(
      "the robot has no joint \"{}\"; {}", name,
      near ? fmt::format("did you mean \"{}\"?", *near) : "its joints are " + io::listed(known));
}

void require_held(const nlohmann::json& load, const dynamics::Tree& tree, const Report& report) {
  if (tree.base == dynamics::BaseKind::kFixed || load.contains("base")) return;
  report("/base",
         "missing; the robot's base floats: write \"held\" if it hung or stood on a stand "
         "while the log was taken (a base that moves cannot be told from its joints yet)");
}

/// Nothing in a rig stands for metres.
void require_turning_joints(const std::vector<std::string>& named, const RobotLoad& robot,
                            const Report& report) {
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    const dynamics::Joint& joint = robot.joints[body];
    if (joint.kind == dynamics::JointKind::kRevolute) continue;
    if (std::find(named.begin(), named.end(), joint.name) == named.end()) continue;
    report("/file", fmt::format("\"{}\" slides: only joints that turn can be read", joint.name));
  }
}

void require_direct_drives(const hopper::Robot& robot, const Report& report) {
  for (const hopper::Drivetrain& drivetrain : robot.drivetrains) {
    const std::string_view type = drivetrain.mechanism->type();
    if (type == "direct") continue;
    const dynamics::Joint& joint = robot.tree.bodies[drivetrain.joints.front()].joint;
    report("/file",
           fmt::format("\"{}\" is moved through a {}: a log of its drives cannot be read as one of "
                       "its joints yet; leave the mechanism out of the robot's document, and its "
                       "joint is judged as if driven directly",
                       joint.name, type));
  }
  for (const hopper::Follower& follower : robot.followers) {
    report("/file",
           fmt::format("\"{}\" carries links that follow it, which are not read here yet; leave "
                       "followers out of the robot's document",
                       robot.tree.bodies[follower.joints.front()].joint.name));
  }
}

}  // namespace

RobotLoad robot_load_of_json(const nlohmann::json& load, const std::filesystem::path& rig_file,
                             const Report& report) {
  RobotLoad read;
  read.file = load["file"];
  const hopper::ReadRobot robot = hopper::read_robot(rig_file.parent_path() / read.file);
  require_held(load, robot.robot.tree, report);
  require_direct_drives(robot.robot, report);
  read.tree = bare_tree(robot.robot.tree);
  for (const dynamics::Body& body : robot.robot.tree.bodies) read.joints.push_back(body.joint);
  const std::vector<std::string> names = joint_names(read.tree);
  const nlohmann::json held = load.value("held_rad", nlohmann::json::object());
  for (const auto& [joint, position] : held.items()) {
    const auto body = robot.robot.find_joint(joint);
    if (body) {
      read.held_rad[*body] = position;
    } else {
      report("/held_rad/" + joint, unknown_joint(joint, names));
    }
  }
  return read;
}

std::vector<std::string> joints_in_log(const std::vector<std::string>& named, RobotLoad& robot,
                                       const Report& report) {
  const std::vector<std::string> known = joint_names(robot.tree);
  for (const std::string& name : named) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    report("", unknown_joint(name, known));
  }
  require_turning_joints(named, robot, report);
  std::vector<std::string> joints, silent;
  std::vector<dynamics::Joint> of_joints;
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    const std::string& name = known[body - 1];
    if (std::find(named.begin(), named.end(), name) != named.end()) {
      if (robot.held_rad.count(body) > 0) report("/held_rad/" + name, "is in the log as well");
      joints.push_back(name);
      robot.bodies.push_back(body);
      of_joints.push_back(robot.joints[body]);
    } else if (robot.held_rad.count(body) == 0) {
      silent.push_back(name);
    }
  }
  robot.joints = std::move(of_joints);
  if (!silent.empty()) {
    report("/held_rad",
           fmt::format("no column is of {}; what does not move is to be stated: {{\"{}\": 0, ...}}",
                       io::listed(silent), silent.front()));
  }
  return joints;
}

}  // namespace torquewright::identification
