// SPDX-License-Identifier: Apache-2.0
#include "tests/hopper/planning/sagittal_states.hpp"

#include <cmath>

#include "robot/mechanisms/parallel_ankle.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::test {

using dynamics::Body;
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

hopper::Robot documented_robot(const std::string& name) {
  return hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/" + name + ".json").robot;
}

hopper::SagittalRobot hopper_with_short_rods() {
  hopper::SagittalRobot plane = sagittal(documented_robot("hopper"));
  auto& mechanism = plane.robot.drivetrains.back().mechanism;
  hopper::ParallelAnkleGeometry geometry =
      dynamic_cast<const hopper::ParallelAnkle&>(*mechanism).geometry();
  for (hopper::AnkleRod& rod : geometry.rods) rod.rod_length_m -= 0.04;
  mechanism = std::make_shared<hopper::ParallelAnkle>(geometry);
  return plane;
}

hopper::Robot leg_with_tail() {
  hopper::Robot robot = documented_robot("planar_leg");
  robot.tree.bodies[1].joint.axis = -Vector3d::UnitY();
  std::swap(robot.tree.bodies[1].joint.limits.position_min,
            robot.tree.bodies[1].joint.limits.position_max);
  for (double* limit : {&robot.tree.bodies[1].joint.limits.position_min,
                        &robot.tree.bodies[1].joint.limits.position_max}) {
    *limit = -*limit;
  }
  Body tail{"tail", 0, {}, {0.4, {-0.1, 0.0, 0.02}, Vector3d(1e-3, 2e-3, 2e-3).asDiagonal()}};
  tail.joint.name = "tail";
  tail.joint.p_PB_m = {-0.15, 0.0, 0.05};
  tail.joint.limits.position_min = -1.5;
  tail.joint.limits.position_max = 1.5;
  Body head{"head", 0, {}, {0.5, {0.05, 0.0, 0.06}, Vector3d(1e-3, 2e-3, 2e-3).asDiagonal()}};
  head.joint.name = "head";
  head.joint.p_PB_m = {0.2, 0.0, 0.05};
  head.joint.axis = Vector3d(0.6, 0.0, 0.8);
  robot.tree.bodies.push_back(tail);
  robot.tree.bodies.push_back(head);
  hopper::Drivetrain drive = robot.drivetrains.front();
  drive.joints = {3};
  drive.actuator_names = {"tail"};
  robot.tree.bodies[3].joint.reflected_inertia = robot.tree.bodies[1].joint.reflected_inertia;
  robot.drivetrains.push_back(drive);
  robot.contacts.front().point.p_B_m.x() = 0.09;
  robot.contacts.push_back({"heel", {2, {-0.06, 0.0, -0.175}}, 0.5, 0.0, 0.0});
  return robot;
}

hopper::Robot pendulum(const Pendulum& of, double heel_m, double toe_m) {
  hopper::Robot robot = documented_robot("planar_leg");
  robot.name = "pendulum";
  robot.tree.bodies.pop_back();
  robot.drivetrains.pop_back();
  robot.postures.clear();
  robot.tree.bodies[0].inertia = {
      of.mass_kg,
      {0.0, 0.0, of.height_m},
      (of.base_kg_m2 - of.mass_kg * of.height_m * of.height_m) * Eigen::Matrix3d::Identity()};
  Body& foot = robot.tree.bodies[1];
  foot.inertia = {of.foot_kg, Vector3d::Zero(), of.foot_kg_m2 * Eigen::Matrix3d::Identity()};
  foot.joint.limits = {};
  foot.joint.reflected_inertia = of.rotor_kg_m2;
  robot.contacts = {{"heel", {1, {-heel_m, 0.0, 0.0}}, 0.6, 0.0, 0.0}};
  if (heel_m + toe_m > 0.0)
    robot.contacts.push_back({"toe", {1, {toe_m, 0.0, 0.0}}, 0.6, 0.0, 0.0});
  return robot;
}

hopper::TreeMotion random_motion(oracles::Dice& dice, const hopper::SagittalRobot& plane) {
  const Index size = plane.robot.tree.velocity_size();
  const VectorXd none = VectorXd::Zero(size);
  hopper::TreeMotion out{none, none, none};
  for (std::size_t i = 0; i < plane.moving.size(); ++i) {
    const Index row = plane.moving[i];
    out.position[row] = uniform(dice, -2, 2);
    out.velocity[row] = uniform(dice, -2, 2);
    out.acceleration[row] = uniform(dice, -50, 50);
    if (i < 3) continue;
    const dynamics::JointLimits& limits = plane.robot.tree.bodies[plane.joints[i - 3]].joint.limits;
    const bool limited = std::isfinite(limits.position_min) && std::isfinite(limits.position_max);
    const double middle = limited ? 0.5 * (limits.position_min + limits.position_max) : 0.0;
    const double half = limited ? 0.5 * (limits.position_max - limits.position_min) : 1.0;
    out.position[row] = middle + 0.9 * half * uniform(dice, -1, 1);
  }
  return out;
}

VectorXd moving_of(const hopper::SagittalRobot& plane, const VectorXd& rows) {
  VectorXd out(plane.moving_count());
  for (Index i = 0; i < out.size(); ++i) out[i] = rows[plane.moving[static_cast<std::size_t>(i)]];
  return out;
}

}  // namespace torquewright::test
