// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/rotors_in_joints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "robot/draft/postures_in_range.hpp"
#include "robot/model/mechanism_reach.hpp"

namespace torquewright::hopper {
namespace {

/// The greatest change of an entry of the reflected inertia within the joints' ranges, couplings
/// included, where the mechanism reaches.
double greatest_change_kg_m2(const dynamics::Tree& tree, const Drivetrain& drivetrain,
                             const SmallVector& armature_kg_m2, const SmallMatrix& held_kg_m2) {
  double greatest = 0;
  for (const SmallVector& q : postures_in_range(tree, drivetrain)) {
    const auto transfer = drivetrain.mechanism->transfer(q, SmallVector::Zero(q.size()));
    if (!transfer) continue;
    const SmallMatrix off = reflected_inertia_kg_m2(*transfer, armature_kg_m2) - held_kg_m2;
    greatest = std::max(greatest, off.cwiseAbs().maxCoeff());
  }
  return greatest;
}

}  // namespace

dynamics::Tree tree_with_rotors(const Robot& robot, std::vector<std::string>& notes) {
  dynamics::Tree tree = robot.tree;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    if (drivetrain.rotors_in_tree) continue;
    const SmallVector home = home_posture_rad(tree, drivetrain.joints);
    const SmallVector rest = SmallVector::Zero(home.size());
    const auto transfer = drivetrain.mechanism->transfer(home, rest);
    SmallVector armature_kg_m2 = rest;
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      armature_kg_m2[static_cast<Eigen::Index>(i)] = turned_at_output_kg_m2(drivetrain, i);
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
    const SmallVector held = reflected.diagonal();
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      tree.bodies[drivetrain.joints[i]].joint.reflected_inertia += reflected(row, row);
    }
    const double off =
        greatest_change_kg_m2(tree, drivetrain, armature_kg_m2, SmallMatrix(held.asDiagonal()));
    notes.push_back(fmt::format(
        "the rotors of {} are written as they weigh at each joint nearest to zero, {:.4g} kg m2 "
        "and less; how this changes with posture and couples joints is not held: up to {:.4g} "
        "kg m2 within the joints' ranges",
        fmt::join(names, ", "), held.maxCoeff(), off));
  }
  return tree;
}

}  // namespace torquewright::hopper
