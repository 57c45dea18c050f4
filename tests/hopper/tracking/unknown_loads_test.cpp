// SPDX-License-Identifier: Apache-2.0
// Oracles: inverse dynamics and mass matrices of robots that differ by that much, quotients at
// another step, and the power that friction takes in closed form.
#include "hopper/tracking/unknown_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOtherStep = 0.03;
constexpr Index kFactors = 2, kBodiesThatWeigh = 3, kWeighedDrives = 3;

struct Moving {
  VectorXd position, velocity, acceleration;
};

Moving moving(const Robot& hopper) {
  Moving at{test::crouch(hopper), VectorXd(9), VectorXd(9)};
  at.velocity << 0.3, 0.1, -0.8, 0.2, 1.5, -0.3, -2.0, 1.2, 0.4;
  at.acceleration << 2.0, -1.0, 12.0, 3.0, -8.0, 1.0, 25.0, -15.0, 4.0;
  return at;
}

/// The hopper with its `unknown`-th number so far from the document's: the factors of masses and of
/// inertias, then thigh, calf and foot by axes.
Robot changed(Robot robot, Index unknown, double by) {
  constexpr std::size_t kBodies[] = {0, 1, 3};
  if (unknown == 0) {
    for (dynamics::Body& body : robot.tree.bodies) body.inertia.mass_kg *= 1.0 + by;
  } else if (unknown == 1) {
    for (dynamics::Body& body : robot.tree.bodies) body.inertia.inertia_kg_m2 *= 1.0 + by;
  } else {
    const auto body = static_cast<std::size_t>((unknown - kFactors) / 3);
    robot.tree.bodies[kBodies[body]].inertia.center_of_mass_m[(unknown - kFactors) % 3] += by;
  }
  return robot;
}

VectorXd asked(const Robot& robot, const Moving& at) {
  WholeBody body(robot);
  VectorXd force(9);
  EXPECT_TRUE(body.set(at.position, at.velocity));
  body.inverse_dynamics(at.acceleration, force);
  return force;
}

MatrixXd mass_of(const Robot& robot, const Moving& at) {
  WholeBody body(robot);
  MatrixXd mass(9, 9);
  EXPECT_TRUE(body.set(at.position, at.velocity));
  body.mass_matrix(mass);
  return mass;
}

TEST(UnknownLoads, AskForWhatRobotsThatDifferAskFor) {
  const Robot robot = test::robot_of("hopper.json");
  const Moving at = moving(robot);
  UnknownLoads loads(robot);
  ASSERT_EQ(loads.size(), kFactors + 3 * kBodiesThatWeigh + kWeighedDrives);
  const auto forces = loads.forces(at.position, at.velocity, at.acceleration);
  ASSERT_TRUE(forces);
  const MatrixXd impulses = loads.impulses(at.position, at.velocity);
  for (Index i = 0; i < kFactors + 3 * kBodiesThatWeigh; ++i) {
    const Robot more = changed(robot, i, kOtherStep), less = changed(robot, i, -kOtherStep);
    const VectorXd slope = (asked(more, at) - asked(less, at)) / (2.0 * kOtherStep);
    EXPECT_LT((forces->col(i) - slope).norm(), 1e-9 * (1.0 + slope.norm())) << i;
    const VectorXd struck =
        (mass_of(more, at) - mass_of(less, at)) * at.velocity / (2.0 * kOtherStep);
    EXPECT_LT((impulses.col(i) - struck).norm(), 1e-9 * (1.0 + struck.norm())) << i;
  }
}

TEST(UnknownLoads, FrictionTakesItsTorqueTimesTheDrivesSpeed) {
  const Robot robot = test::robot_of("hopper.json");
  const Moving at = moving(robot);
  UnknownLoads loads(robot);
  const auto forces = loads.forces(at.position, at.velocity, at.acceleration);
  ASSERT_TRUE(forces);
  WholeBody body(robot);
  ASSERT_TRUE(body.set(at.position, at.velocity));
  VectorXd speed_rad_s(kWeighedDrives);
  body.speed_changes(at.velocity, speed_rad_s);
  for (Index drive = 0; drive < kWeighedDrives; ++drive) {
    const double power_W = at.velocity.dot(forces->rightCols(kWeighedDrives).col(drive));
    const double most_W = std::abs(speed_rad_s[drive]);  // of 1 Nm; smoothed within 0.1 rad/s
    EXPECT_LE(power_W, most_W);
    EXPECT_GT(power_W, most_W * (1.0 - 0.5 * std::pow(0.1 / speed_rad_s[drive], 2)) - 1e-12);
  }
  EXPECT_TRUE(loads.impulses(at.position, at.velocity).rightCols(kWeighedDrives).isZero(0.0));
}

}  // namespace
}  // namespace torquewright::hopper
