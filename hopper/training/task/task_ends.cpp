// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/task/task_ends.hpp"

#include <Eigen/Geometry>

namespace torquewright::hopper {
namespace {

using Eigen::Index;

void turn(const dynamics::Tree& tree, double turn_rad, Eigen::Ref<Eigen::VectorXd> position) {
  if (tree.base == dynamics::BaseKind::kPlanar) {
    position[2] += turn_rad;
    return;
  }
  const Eigen::Quaterniond began(position[3], position[4], position[5], position[6]);
  const Eigen::Quaterniond ends =
      Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()) * began.normalized();
  position.segment<4>(3) << ends.w(), ends.x(), ends.y(), ends.z();
}

}  // namespace

Motion motion_of_ends(const ReadyTask& ready) {
  const dynamics::Tree& tree = ready.robot.tree;
  Motion motion;
  motion.file = ready.task.file;
  motion.times_s = {0.0, ready.task.duration_s};
  motion.positions.resize(tree.position_size(), 2);
  motion.positions.colwise() = ready.start_position;
  turn(tree, ready.task.goal.turn_rad, motion.positions.col(1));
  motion.velocities.setZero(tree.velocity_size(), 2);
  motion.accelerations.setZero(tree.velocity_size(), 2);
  motion.has_effort.assign(tree.bodies.size() - 1, false);
  return motion;
}

Reference reference_of_ends(const ReadyTask& ready) {
  ContactSchedule contacts;
  contacts.touches.setConstant(static_cast<Index>(ready.robot.contacts.size()), 2, true);
  Index drives = 0;
  for (const Drivetrain& drivetrain : ready.robot.drivetrains) {
    drives += static_cast<Index>(drivetrain.actuators.size());
  }
  return Reference(ready.robot, motion_of_ends(ready), contacts, Eigen::MatrixXd::Zero(drives, 2));
}

}  // namespace torquewright::hopper
