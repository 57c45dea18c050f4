// SPDX-License-Identifier: Apache-2.0
#include "hopper/files/rotors_in_joints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "actuator/check/drive_check.hpp"
#include "hopper/robot/mechanism_reach.hpp"

namespace torquewright::hopper {

dynamics::Tree tree_with_rotors(const Robot& robot, std::vector<std::string>& notes) {
  dynamics::Tree tree = robot.tree;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    if (drivetrain.rotors_in_tree) continue;
    const SmallVector home = home_posture_rad(tree, drivetrain.joints);
    const SmallVector rest = SmallVector::Zero(home.size());
    const auto transfer = drivetrain.mechanism->transfer(home, rest);
    SmallVector armature_kg_m2 = rest;
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      armature_kg_m2[static_cast<Eigen::Index>(i)] =
          actuator::armature_kg_m2(drivetrain.actuators[i]);
    }
    std::vector<std::string> names;
    for (const std::size_t body : drivetrain.joints) names.push_back(tree.bodies[body].joint.name);
    if (!transfer) {
      notes.push_back(
          fmt::format("the rotors of {} are not held: the mechanism is singular where "
                      "its joints are nearest to zero",
                      fmt::join(names, ", ")));
      continue;
    }
    const SmallMatrix reflected = reflected_inertia_kg_m2(*transfer, armature_kg_m2);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      tree.bodies[drivetrain.joints[i]].joint.reflected_inertia += reflected(row, row);
    }
    notes.push_back(
        fmt::format("the rotors of {} stand as they weigh at each joint nearest to "
                    "zero: their change with posture and their coupling of joints are "
                    "not held",
                    fmt::join(names, ", ")));
  }
  return tree;
}

}  // namespace torquewright::hopper
