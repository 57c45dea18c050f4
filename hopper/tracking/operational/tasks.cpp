// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/operational/tasks.hpp"

#include <set>

#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {
namespace {

/// Beside the centre of mass and the attitude, which decide whether a robot falls, a posture
/// decides what they leave open.
constexpr double kPostureWeight = 0.01;

std::set<std::size_t> joints_of_drives(const Robot& robot) {
  std::set<std::size_t> joints;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    joints.insert(drivetrain.joints.begin(), drivetrain.joints.end());
  }
  return joints;
}

std::vector<RigidJoint> springs_without_drive(const Robot& robot,
                                              const std::set<std::size_t>& driven) {
  std::vector<RigidJoint> springs;
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    const bool is_spring = robot.tree.bodies[body].joint.passive.stiffness > 0.0;
    if (is_spring && !driven.contains(body)) springs.push_back({false, body});
  }
  const WholeBody whole(robot);
  const auto links = whole.links();
  for (std::size_t link = 0; link < links.size(); ++link) {
    if (links[link].joint.passive.stiffness > 0.0) springs.push_back({true, link});
  }
  return springs;
}

}  // namespace

std::string_view name_of(TaskKind kind) {
  switch (kind) {
    case TaskKind::kCenterOfMass:
      return "center_of_mass";
    case TaskKind::kBaseAttitude:
      return "base_attitude";
    case TaskKind::kPoint:
      return "point";
    default:
      return "joint";
  }
}

OperationalTasks usual_tasks(const Robot& robot) {
  OperationalTasks all;
  all.name = "usual";
  all.tasks.push_back({.kind = TaskKind::kCenterOfMass, .when = TaskTime::kStance});
  all.tasks.push_back({.kind = TaskKind::kBaseAttitude, .when = TaskTime::kStance});
  const std::set<std::size_t> driven = joints_of_drives(robot);
  for (const std::size_t body : driven) {
    all.tasks.push_back({.kind = TaskKind::kJoint,
                         .of = body,
                         .when = TaskTime::kStance,
                         .weight = kPostureWeight});
    all.tasks.push_back({.kind = TaskKind::kJoint, .of = body, .when = TaskTime::kFlight});
  }
  all.rigid = springs_without_drive(robot, driven);
  return all;
}

std::string words_of(const OperationalTask& task, const Robot& robot) {
  std::string words(name_of(task.kind));
  if (task.kind == TaskKind::kPoint) words += " " + robot.contacts[task.of].name;
  if (task.kind == TaskKind::kJoint) words += " " + robot.tree.bodies[task.of].joint.name;
  if (task.when == TaskTime::kStance) words += ", stance";
  if (task.when == TaskTime::kFlight) words += ", flight";
  return words;
}

}  // namespace torquewright::hopper
