// SPDX-License-Identifier: Apache-2.0
// Oracle: closed form of a block on one ankle.
#include "hopper/tracking/tipping_torque.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "robot/mechanisms/constant_jacobian.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::VectorXd;

constexpr double kFoot_kg = 0.7, kBlock_kg = 9.0, kInertia_kg_m2 = 0.3;
constexpr double kAnkle_m = 0.08, kHeight_m = 0.45;  // of the ankle; of the block's mass over it
constexpr double kHeel_m = -0.08, kToe_m = 0.12, kGearing = 3.0;

/// A flat foot with a heel and a toe, upright on it a block, moved by one drive through a gear.
Robot block_on_an_ankle() {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kPlanar;
  dynamics::Body foot, block;
  foot.name = "foot";
  foot.inertia = {kFoot_kg, {0.01, 0, 0.03}, Eigen::Vector3d::Constant(1e-3).asDiagonal()};
  block.name = "block";
  block.parent = 0;
  block.joint.name = "ankle";
  block.joint.axis = Eigen::Vector3d::UnitY();
  block.joint.p_PB_m = {0, 0, kAnkle_m};
  block.inertia = {
      kBlock_kg, {0, 0, kHeight_m}, Eigen::Vector3d::Constant(kInertia_kg_m2).asDiagonal()};
  robot.tree.bodies = {foot, block};
  robot.contacts = {{"heel", {0, {kHeel_m, 0, 0}}, 1.0, 0.0, 0.0},
                    {"toe", {0, {kToe_m, 0, 0}}, 1.0, 0.0, 0.0}};
  Drivetrain drive;
  drive.mechanism = std::make_shared<ConstantJacobian>(
      "gear", SmallMatrix(SmallMatrix::Constant(1, 1, kGearing)));
  drive.joints = {1};
  drive.actuators.resize(1);
  drive.actuator_names = {"ankle"};
  robot.drivetrains = {drive};
  return robot;
}

VectorXd tipping_of(const Robot& robot, const TouchingPoints& touches) {
  WholeBody body(robot);
  const VectorXd rest = VectorXd::Zero(4);
  return tipping_torques_Nm(body, {rest, rest, VectorXd::Zero(1)}, touches).value();
}

// The ankle's torque t turns the block at t/(I + m l^2) and by its reaction the foot; the block's
// mass pushes the foot back by m l t/(I + m l^2) at the ankle's height. Half the foot's length
// times the weight stands against both: t (1 + m l h/(I + m l^2)) = W length/2. The drive gives
// t/gearing.
TEST(TippingTorque, OfABlockOnOneAnkle) {
  const Robot robot = block_on_an_ankle();
  const double about_ankle = kInertia_kg_m2 + kBlock_kg * kHeight_m * kHeight_m;
  const double weight_N = (kFoot_kg + kBlock_kg) * robot.tree.gravity_m_s2;
  const double expected_Nm = weight_N * 0.5 * (kToe_m - kHeel_m) /
                             (1.0 + kBlock_kg * kHeight_m * kAnkle_m / about_ankle) / kGearing;
  const VectorXd found_Nm = tipping_of(robot, TouchingPoints::Constant(2, true));
  EXPECT_NEAR(found_Nm[0], expected_Nm, 1e-9 * expected_Nm);
}

/// The same in space, its foot two points beside each other, rolled by the drive; its mass is over
/// the line between them, about which nothing holds it.
Robot block_on_a_rolling_ankle() {
  Robot robot = block_on_an_ankle();
  robot.tree.base = dynamics::BaseKind::kSpatial;
  robot.tree.bodies[0].inertia.center_of_mass_m.x() = 0.0;
  robot.tree.bodies[1].joint.axis = Eigen::Vector3d::UnitX();
  robot.contacts[0].point.p_B_m = {0, kHeel_m, 0};
  robot.contacts[1].point.p_B_m = {0, kToe_m, 0};
  return robot;
}

// On a line of points the ends are what it tips over: the same closed form.
TEST(TippingTorque, OverALineIsThatOfItsEnds) {
  const Robot robot = block_on_a_rolling_ankle();
  WholeBody body(robot);
  VectorXd position = VectorXd::Zero(8);
  position[3] = 1.0;  // the quaternion's real part
  const VectorXd rest = VectorXd::Zero(7);
  const double about_ankle = kInertia_kg_m2 + kBlock_kg * kHeight_m * kHeight_m;
  const double expected_Nm = (kFoot_kg + kBlock_kg) * robot.tree.gravity_m_s2 * 0.5 *
                             (kToe_m - kHeel_m) /
                             (1.0 + kBlock_kg * kHeight_m * kAnkle_m / about_ankle) / kGearing;
  const auto found_Nm = tipping_torques_Nm(body, {position, rest, VectorXd::Zero(1)},
                                           TouchingPoints::Constant(2, true));
  ASSERT_TRUE(found_Nm);
  EXPECT_NEAR((*found_Nm)[0], expected_Nm, 1e-9 * expected_Nm);
}

TEST(TippingTorque, IsInfiniteWhereNothingIsSpanned) {
  const Robot robot = block_on_an_ankle();
  TouchingPoints heel = TouchingPoints::Constant(2, true);
  heel[1] = false;
  EXPECT_TRUE(std::isinf(tipping_of(robot, heel)[0]));
  EXPECT_TRUE(std::isinf(tipping_of(robot, TouchingPoints::Constant(2, false))[0]));
}

}  // namespace
}  // namespace torquewright::hopper
