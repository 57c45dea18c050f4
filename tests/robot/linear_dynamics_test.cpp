// SPDX-License-Identifier: Apache-2.0
// Oracle: fourth-order differences of the double version, its touching points found by
// touching_point(), its accelerations by Jacobians and their rates.
#include "robot/model/linear_dynamics.hpp"

#include <gtest/gtest.h>

#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "robot/mechanisms/four_bar.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/touching_point.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using oracles::Dice;
using test::difference;
using test::uniform;
using test::uniform_vector;
using Matrix3X = Eigen::Matrix<double, 3, Eigen::Dynamic>;

// h^4/30 of the fifth derivative, which grows by up to 10 per derivative where rods of centimetres
// turn, is 2e-9; eps/h is 1e-12.
constexpr double kDifferenceStep = 5e-4;
constexpr double kOfDifferences = 5e-9;

/// Residual, touching speeds and their rates, one below the other.
VectorXd equations(WholeBody& body, const DynamicsInstant& at) {
  EXPECT_TRUE(body.set(at.position, at.velocity));
  const std::vector<ContactPoint>& contacts = body.robot().contacts;
  const Index n = at.velocity.size(), points = static_cast<Index>(contacts.size());
  VectorXd force(n), others = VectorXd::Zero(n), all(n + 6 * points);
  Matrix3X jacobian(3, n);
  body.inverse_dynamics(at.acceleration, force);
  body.add_drive_torques(at.drive_Nm, others);
  for (Index i = 0; i < points; ++i) {
    const ContactPoint& contact = contacts[static_cast<std::size_t>(i)];
    const dynamics::BodyPoint point = touching_point(contact, body.state());
    dynamics::add_point_force(body.state(), point, at.contact_N.col(i), others);
    dynamics::point_jacobian(body.state(), point, jacobian);
    all.segment<3>(n + 3 * i) = jacobian * at.velocity;
    // The material under a ball's centre turns away; the centre itself has no such part.
    const Vector3d w = body.state().motion(point.body).angular_velocity_rad_s;
    const Vector3d down_m(0, 0, -contact.radius_m);
    all.segment<3>(n + 3 * (points + i)) =
        jacobian * at.acceleration + dynamics::point_bias_acceleration_m_s2(body.state(), point) -
        w.cross(w.cross(down_m));
  }
  all.head(n) = force - others;
  return all;
}

template <typename Function>
MatrixXd slopes_by(Index count, const Function& value_at) {
  MatrixXd slopes(value_at(VectorXd::Zero(count)).size(), count);
  for (Index j = 0; j < count; ++j) {
    const VectorXd step = kDifferenceStep * VectorXd::Unit(count, j);
    slopes.col(j) =
        (8 * (value_at(step) - value_at(-step)) - (value_at(2 * step) - value_at(-2 * step))) /
        (12 * kDifferenceStep);
  }
  return slopes;
}

void expect_slopes(const Robot& robot, const DynamicsInstant& at) {
  LinearDynamics linear(robot);
  DynamicsSlopes found;
  ASSERT_TRUE(linear.at(at, found));
  WholeBody body(robot);
  const Index n = at.velocity.size(), contacts = found.contact_m_s.size();
  const VectorXd value = equations(body, at);
  EXPECT_LE(difference(found.residual, value.head(n)), 1e-11);
  EXPECT_LE(difference(found.contact_m_s, value.segment(n, contacts)), 1e-11);
  EXPECT_LE(difference(found.contact_m_s2, value.tail(contacts)), 1e-11);
  const MatrixXd by_position = slopes_by(n, [&](const VectorXd& step) {
    DynamicsInstant there = at;
    dynamics::step_position(robot.tree, at.position, step, 1, there.position);
    return equations(body, there);
  });
  const MatrixXd by_velocity = slopes_by(n, [&](const VectorXd& step) {
    DynamicsInstant there = at;
    there.velocity += step;
    return equations(body, there);
  });
  EXPECT_LE(difference(found.residual_by_position, by_position.topRows(n)), kOfDifferences);
  EXPECT_LE(difference(found.residual_by_velocity, by_velocity.topRows(n)), kOfDifferences);
  EXPECT_LE(difference(found.contact_m_s_by_position, by_position.middleRows(n, contacts)),
            kOfDifferences);
  EXPECT_LE(difference(found.contact_m_s2_by_position, by_position.bottomRows(contacts)),
            kOfDifferences);
  EXPECT_LE(difference(found.contact_m_s2_by_velocity, by_velocity.bottomRows(contacts)),
            kOfDifferences);
}

DynamicsInstant drawn_instant(Dice& dice, const Robot& robot, std::size_t drives) {
  const Index n = robot.tree.velocity_size();
  DynamicsInstant at;
  at.position = test::random_position(dice, robot.tree);
  if (robot.tree.base == dynamics::BaseKind::kSpatial) at.position.segment<4>(3).normalize();
  at.velocity = uniform_vector(dice, n, 4);
  at.acceleration = uniform_vector(dice, n, 20);
  at.drive_Nm = uniform_vector(dice, static_cast<Index>(drives), 100);
  at.contact_N.resize(3, static_cast<Index>(robot.contacts.size()));
  for (Index i = 0; i < at.contact_N.cols(); ++i) {
    at.contact_N.col(i) = dice.chance(70) ? uniform_vector(dice, 3, 300) : Vector3d::Zero();
  }
  return at;
}

TEST(LinearDynamics, OfTheHopperWithItsRodsAndABallForAContact) {
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  ASSERT_FALSE(robot.contacts.empty());
  robot.contacts.front().radius_m = 0.03;
  Dice dice(61);
  const std::size_t drives = WholeBody(robot).drive_count();
  for (int i = 0; i < 20; ++i) {
    DynamicsInstant at = drawn_instant(dice, robot, drives);
    at.position.tail<3>() << uniform(dice, 0.3, 1.8), uniform(dice, -0.4, 0.4),
        uniform(dice, -0.2, 0.2);
    expect_slopes(robot, at);
  }
}

// 36 variables and more: in two passes.
TEST(LinearDynamics, OfRobotsWithMoreVariablesThanOneNumberHolds) {
  Dice dice(62);
  for (const auto base : {dynamics::BaseKind::kSpatial, dynamics::BaseKind::kPlanar}) {
    Robot robot;
    robot.tree = test::random_tree(dice, base, 15);
    robot.contacts.push_back({"foot", {15, {0.1, 0.2, -0.3}}, 0.5, 0, 0});
    robot.contacts.push_back({"ball", {9, {0.1, 0, -0.1}}, 0.5, 0, 0.2});
    expect_slopes(robot, drawn_instant(dice, robot, 0));
  }
}

TEST(LinearDynamics, SaysWhereAMechanismDoesNotReachAndRefusesWrongSizes) {
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  FourBarGeometry links;  // at zero its pin stands 6 from the crank's pivot, whose links reach 4
  links.crank_m = 1;
  links.coupler_m = 3;
  links.rocker_m = 2.5;
  links.ground_m = 3.5;
  robot.drivetrains.front().mechanism = std::make_shared<FourBar>(links);
  Dice dice(63);
  LinearDynamics linear(robot);
  DynamicsInstant at = drawn_instant(dice, robot, WholeBody(robot).drive_count());
  at.position.tail<3>().setZero();
  DynamicsSlopes found;
  EXPECT_FALSE(linear.at(at, found));
  at.drive_Nm.resize(1);
  EXPECT_THROW((void)linear.at(at, found), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::hopper
