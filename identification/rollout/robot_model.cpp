// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/robot_model.hpp"

#include <algorithm>
#include <map>

namespace torquewright::identification {
namespace {

bool is_moved(const RobotLoad& robot, std::size_t body) {
  return std::find(robot.bodies.begin(), robot.bodies.end(), body) != robot.bodies.end();
}

/// The first moved body on the way from the base to this one.
std::size_t root_of(const RobotLoad& robot, std::size_t body) {
  std::size_t root = body;
  for (std::size_t each = body; each != 0; each = robot.tree.bodies[each].parent) {
    if (is_moved(robot, each)) root = each;
  }
  return root;
}

/// Bodies from the base to the root, and those that it carries.
std::vector<bool> kept_bodies(const dynamics::Tree& tree, std::size_t root) {
  std::vector<bool> kept(tree.bodies.size(), false);
  kept[0] = true;
  for (std::size_t each = root; each != 0; each = tree.bodies[each].parent) kept[each] = true;
  for (std::size_t each = root + 1; each < tree.bodies.size(); ++each) {
    std::size_t up = each;
    while (up > root) up = tree.bodies[up].parent;
    if (up == root) kept[each] = true;
  }
  return kept;
}

Limb limb_of(const Load& load, std::size_t root, std::vector<std::size_t> joints) {
  const RobotLoad& robot = *load.robot;
  const std::vector<bool> kept = kept_bodies(robot.tree, root);
  RobotLoad part;
  part.file = robot.file;
  part.tree = robot.tree;
  part.tree.bodies.clear();
  std::vector<std::size_t> place(kept.size(), 0);
  for (std::size_t body = 0; body < kept.size(); ++body) {
    if (!kept[body]) continue;
    place[body] = part.tree.bodies.size();
    part.tree.bodies.push_back(robot.tree.bodies[body]);
    part.tree.bodies.back().parent = place[robot.tree.bodies[body].parent];
    const auto held = robot.held_rad.find(body);
    if (held != robot.held_rad.end()) part.held_rad[place[body]] = held->second;
  }
  for (const std::size_t joint : joints) {
    part.bodies.push_back(place[robot.bodies[joint]]);
    part.joints.push_back(robot.joints[joint]);
  }
  Limb limb{std::move(joints), load};
  limb.load.robot = std::make_shared<const RobotLoad>(std::move(part));
  return limb;
}

}  // namespace

RobotModel robot_model(const Rig& rig, const std::vector<const actuator::Actuator*>& drives) {
  RobotModel model{rig.load, {}, {}, std::vector<double>(drives.size(), 0.0)};
  for (const auto& each : rig.controllers) {
    model.controllers.push_back(each.value_or(JointController()));
  }
  for (const actuator::Actuator* each : drives) model.drives.push_back(*each);
  return model;
}

std::vector<Limb> limbs_of(const Load& robot) {
  std::map<std::size_t, std::vector<std::size_t>> joints_by_root;
  for (std::size_t joint = 0; joint < robot.robot->bodies.size(); ++joint) {
    joints_by_root[root_of(*robot.robot, robot.robot->bodies[joint])].push_back(joint);
  }
  std::vector<Limb> limbs;
  for (auto& [root, joints] : joints_by_root) {
    limbs.push_back(limb_of(robot, root, std::move(joints)));
  }
  return limbs;
}

}  // namespace torquewright::identification
