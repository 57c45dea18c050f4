// SPDX-License-Identifier: Apache-2.0
// Oracles: the tree with the same inertia on its joints (where that is the same robot), kinetic
// energy written out rotor by rotor, and power, which no mechanism makes.
#include "robot/model/whole_body.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/mechanisms/four_bar.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

actuator::Actuator geared(double ratio, double rotor_kg_m2) {
  actuator::Actuator actuator;
  actuator.motor.rotor_inertia_kg_m2 = rotor_kg_m2;
  actuator.transmission.ratio = ratio;
  return actuator;
}

/// A chain of revolute joints, the first driven alone, the next two together.
Robot three_jointed(bool rotors_in_tree) {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kSpatial;
  for (std::size_t i = 0; i < 4; ++i) {
    dynamics::Body body;
    body.name = "body" + std::to_string(i);
    body.parent = i == 0 ? 0 : i - 1;
    body.joint.name = "joint" + std::to_string(i);
    body.joint.axis = i == 2 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    body.joint.p_PB_m = Eigen::Vector3d(0.1, 0, -0.3);
    body.inertia = {1.0 + static_cast<double>(i),
                    {0.02, 0.01, -0.1},
                    Eigen::Vector3d(0.02, 0.03, 0.025).asDiagonal()};
    robot.tree.bodies.push_back(body);
  }
  Drivetrain knee;
  knee.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
  knee.joints = {1};
  knee.actuators = {geared(20, 1e-3)};
  knee.actuator_names = {"knee"};
  robot.tree.bodies[1].joint.reflected_inertia = 0.4;
  Drivetrain ankle;
  SmallMatrix J(2, 2);
  J << 1, 0.5, 1, -0.5;
  ankle.mechanism = std::make_shared<ConstantJacobian>("parallel", J);
  ankle.joints = {2, 3};
  ankle.actuators = {geared(8, 2e-4), geared(8, 3e-4)};
  ankle.actuator_names = {"left", "right"};
  ankle.rotors_in_tree = rotors_in_tree;
  robot.drivetrains = {knee, ankle};
  return robot;
}

struct Instant {
  VectorXd position;
  VectorXd velocity;
  VectorXd acceleration;
};

Instant random_instant(const dynamics::Tree& tree, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Instant instant{VectorXd(tree.position_size()), VectorXd(tree.velocity_size()),
                  VectorXd(tree.velocity_size())};
  for (VectorXd* vector : {&instant.position, &instant.velocity, &instant.acceleration}) {
    for (double& value : *vector) value = normal(random);
  }
  instant.position.segment<4>(3).normalize();
  return instant;
}

TEST(WholeBody, HasTheRotorsOfASingleDriveOnItsJoint) {
  const Robot robot = three_jointed(true);
  WholeBody body(robot);
  dynamics::TreeState tree(robot.tree);  // 0.4 kg m2 on the first joint
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Instant at = random_instant(robot.tree, seed);
    ASSERT_TRUE(body.set(at.position, at.velocity));
    tree.set(at.position, at.velocity);
    MatrixXd ours(9, 9), theirs(9, 9);
    body.mass_matrix(ours);
    dynamics::mass_matrix(tree, theirs);
    EXPECT_LE((ours - theirs).norm(), 1e-12);
    VectorXd force(9), expected(9);
    body.inverse_dynamics(at.acceleration, force);
    dynamics::inverse_dynamics(tree, at.acceleration, expected);
    EXPECT_LE((force - expected).norm(), 1e-11);
  }
}

TEST(WholeBody, CouplesJointsThatShareTheirRotors) {
  const Robot robot = three_jointed(false);
  WholeBody body(robot);
  Robot bare = three_jointed(true);
  bare.tree.bodies[1].joint.reflected_inertia = 0;
  dynamics::TreeState bodies(bare.tree);
  const double left = 64 * 2e-4;
  const double right = 64 * 3e-4;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Instant at = random_instant(robot.tree, seed);
    ASSERT_TRUE(body.set(at.position, at.velocity));
    bodies.set(at.position, at.velocity);
    MatrixXd whole(9, 9), alone(9, 9);
    body.mass_matrix(whole);
    dynamics::mass_matrix(bodies, alone);
    const VectorXd& v = at.velocity;
    const double rotors_J = 0.5 * (0.4 * v[6] * v[6] + left * std::pow(v[7] + 0.5 * v[8], 2) +
                                   right * std::pow(v[7] - 0.5 * v[8], 2));
    EXPECT_NEAR(0.5 * v.dot(whole * v), 0.5 * v.dot(alone * v) + rotors_J, 1e-11);
    VectorXd moving(9), still(9);
    body.inverse_dynamics(at.acceleration, moving);
    body.inverse_dynamics(VectorXd::Zero(9), still);
    EXPECT_LE((moving - still - whole * at.acceleration).norm(), 1e-10);
  }
}

TEST(WholeBody, LosesNoPowerBetweenJointsAndActuators) {
  const Robot robot = three_jointed(false);
  WholeBody body(robot);
  const Instant at = random_instant(robot.tree, 3);
  ASSERT_TRUE(body.set(at.position, at.velocity));
  std::vector<DriveInstant> drives;
  body.drives(at.acceleration, at.acceleration, drives);  // any load
  ASSERT_EQ(drives.size(), 3u);
  double power_W = 0.0;
  for (const DriveInstant& drive : drives) power_W += drive.load_torque_Nm * drive.speed_rad_s;
  EXPECT_NEAR(power_W, at.acceleration.tail(3).dot(at.velocity.tail(3)), 1e-12);
  EXPECT_NEAR(drives[1].torque_Nm - drives[1].load_torque_Nm,
              64 * 2e-4 * (at.acceleration[7] + 0.5 * at.acceleration[8]), 1e-12);
}

// A rotor behind a ratio that varies: at constant joint speed the torque is what changes its
// energy, I A^2 v^2 / 2, with the slope of A taken from two postures nearby.
TEST(WholeBody, MovesARotorBehindAVaryingRatio) {
  Robot robot;
  robot.tree.gravity_m_s2 = 0;
  dynamics::Body arm;
  arm.joint.name = "knee";
  arm.inertia = {1, Eigen::Vector3d::Zero(), 0.1 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies = {dynamics::Body{}, arm};
  Drivetrain knee;
  FourBarGeometry links;
  links.crank_m = 0.05;
  links.coupler_m = 0.15;
  links.rocker_m = 0.08;
  links.ground_m = 0.15;
  links.rocker_zero_rad = 1.3;
  knee.mechanism = std::make_shared<FourBar>(links);
  knee.joints = {1};
  knee.actuators = {geared(10, 3e-3)};
  knee.actuator_names = {"knee"};
  knee.rotors_in_tree = false;
  robot.drivetrains = {knee};
  WholeBody body(robot);
  constexpr double kSpeed = 2.0;
  constexpr double kStep = 1e-5;
  const auto square = [&](double q) {
    const auto at = knee.mechanism->transfer(SmallVector::Constant(1, q), SmallVector::Zero(1));
    return at->jacobian(0, 0) * at->jacobian(0, 0);
  };
  for (const double q : {0.2, 0.4, 0.6}) {
    const VectorXd position = VectorXd::Constant(1, q);
    ASSERT_TRUE(body.set(position, VectorXd::Constant(1, kSpeed)));
    VectorXd torque(1);
    body.inverse_dynamics(VectorXd::Zero(1), torque);
    const double rise = 0.3 * (square(q + kStep) - square(q - kStep)) / (4 * kStep);
    EXPECT_NEAR(torque[0], rise * kSpeed * kSpeed, 1e-7 * std::abs(torque[0]));
    EXPECT_GT(std::abs(torque[0]), 1e-3);  // else nothing was tried
    MatrixXd mass(1, 1);
    body.mass_matrix(mass);
    EXPECT_NEAR(mass(0, 0), 0.1 + 0.3 * square(q), 1e-12);
  }
}

}  // namespace
}  // namespace torquewright::hopper
