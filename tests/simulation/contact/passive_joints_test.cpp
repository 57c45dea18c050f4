// SPDX-License-Identifier: Apache-2.0
// Oracles: closed forms of a wheel with a damper, a spring, dry friction, and of a block that a
// slide's friction holds on the ground.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/contact/time_stepping.hpp"

namespace torquewright::simulation {
namespace {

using Eigen::VectorXd;

constexpr double kInertia_kg_m2 = 0.2;

/// A balanced wheel on a fixed hinge.
dynamics::Tree wheel(const dynamics::PassiveForces& passive) {
  dynamics::Tree tree;
  tree.bodies.resize(2);
  tree.bodies[1].inertia = {1.0, Eigen::Vector3d::Zero(),
                            kInertia_kg_m2 * Eigen::Matrix3d::Identity()};
  tree.bodies[1].joint.passive = passive;
  return tree;
}

struct Turning {
  double position_rad = 0.0;
  double speed_rad_s = 0.0;
};

Turning after(double duration_s, double step_s, const dynamics::Tree& tree, Turning from,
              double torque_Nm = 0.0) {
  BareTree bodies(tree);
  TimeStepping stepping(bodies, {.points = {}, .frictions = joint_frictions(tree)});
  VectorXd position = VectorXd::Constant(1, from.position_rad);
  VectorXd velocity = VectorXd::Constant(1, from.speed_rad_s);
  const VectorXd force = VectorXd::Constant(1, torque_Nm);
  for (int i = 0; i < std::lround(duration_s / step_s); ++i) {
    if (stepping.step(position, velocity, force, step_s) != TimeStepping::Outcome::kStepped) {
      ADD_FAILURE() << i;
      break;
    }
  }
  return {position[0], velocity[0]};
}

// v = v_0 e^(-d t/I), with an error of second order in the step.
TEST(PassiveJoint, SlowsDownByItsDamper) {
  constexpr double kDamping = 0.8;
  const double expected = 5.0 * std::exp(-kDamping / kInertia_kg_m2 * 0.5);
  const auto error = [&](double step_s) {
    return after(0.5, step_s, wheel({.damping = kDamping}), {0.0, 5.0}).speed_rad_s - expected;
  };
  EXPECT_LT(std::abs(error(1e-3)), 1e-5);
  EXPECT_NEAR(error(2e-3) / error(1e-3), 4.0, 0.1);
}

// A damper whose time is a thousandth of the step stops the wheel and neither rings nor blows up.
TEST(PassiveJoint, MayBeStiff) {
  constexpr double kStep_s = 1e-3;
  const Turning end = after(kStep_s, kStep_s, wheel({.damping = 2e5}), {0.0, 5.0});
  EXPECT_NEAR(end.speed_rad_s, 0.0, 1e-9);
  EXPECT_NEAR(end.position_rad, 0.0, 5.0 * kStep_s);
}

// q = q_0 + a cos(w t) without loss.
TEST(PassiveJoint, SwingsOnItsSpring) {
  constexpr double kStiffness = 20.0, kRest = 0.3;
  const double w = std::sqrt(kStiffness / kInertia_kg_m2);
  const Turning end =
      after(0.7, 1e-4, wheel({.stiffness = kStiffness, .rest_position = kRest}), {0.8, 0.0});
  EXPECT_NEAR(end.position_rad, kRest + 0.5 * std::cos(w * 0.7), 1e-6);
  EXPECT_NEAR(end.speed_rad_s, -0.5 * w * std::sin(w * 0.7), 1e-5);
}

// v = v_0 - f t/I until it stands, after v_0^2 I/(2 f) rad; then it stays.
TEST(PassiveJoint, RunsDownByDryFrictionAndStays) {
  constexpr double kFriction = 1.5;
  const dynamics::Tree tree = wheel({.dry_friction = kFriction});
  const Turning on_the_way = after(0.4, 1e-4, tree, {0.0, -5.0});
  EXPECT_NEAR(on_the_way.speed_rad_s, -5.0 + kFriction / kInertia_kg_m2 * 0.4, 1e-9);
  const Turning end = after(2.0, 1e-4, tree, {0.0, -5.0});
  EXPECT_NEAR(end.speed_rad_s, 0.0, 1e-9);
  EXPECT_NEAR(end.position_rad, -5.0 * 5.0 * kInertia_kg_m2 / (2.0 * kFriction), 3e-4);
}

// Held up to the static limit; what breaks loose is slowed by the dry friction alone.
TEST(PassiveJoint, BreaksLooseAtItsStaticFriction) {
  const dynamics::Tree tree = wheel({.dry_friction = 1.0, .static_friction = 1.6});
  EXPECT_NEAR(after(0.5, 1e-3, tree, {}, 1.59).position_rad, 0.0, 1e-9);
  EXPECT_NEAR(after(0.5, 1e-3, tree, {}, -1.59).position_rad, 0.0, 1e-9);
  const Turning loose = after(0.5, 1e-3, tree, {}, 1.61);
  EXPECT_NEAR(loose.speed_rad_s, 0.61 / kInertia_kg_m2 * 0.5, 0.01);
}

// A weight on a vertical slide above the ground: as much as the slide's friction does not hold
// stands on it.
TEST(PassiveJoint, SharesALoadWithTheGround) {
  constexpr double kMass_kg = 2.0, kFriction_N = 5.0, kStep_s = 1e-3;
  dynamics::Tree tree;
  tree.bodies.resize(2);
  tree.bodies[1].joint.kind = dynamics::JointKind::kPrismatic;
  tree.bodies[1].joint.axis = Eigen::Vector3d::UnitZ();
  tree.bodies[1].joint.passive.dry_friction = kFriction_N;
  tree.bodies[1].inertia = {kMass_kg, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()};
  BareTree bodies(tree);
  TimeStepping stepping(bodies, {.points = {{{1, Eigen::Vector3d::Zero()}, 0.5, 0.0}},
                                 .frictions = joint_frictions(tree)});
  VectorXd position = VectorXd::Zero(1), velocity = VectorXd::Constant(1, -1e-3);
  const VectorXd force = VectorXd::Zero(1);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(stepping.step(position, velocity, force, kStep_s), TimeStepping::Outcome::kStepped);
    const double up_N = stepping.generalised_impulse()[0] / kStep_s;
    if (i > 0) {
      EXPECT_NEAR(up_N, kMass_kg * dynamics::kGravity_m_s2, 1e-6);
    }
    EXPECT_GE(stepping.impulses_N_s()[2] / kStep_s,
              kMass_kg * dynamics::kGravity_m_s2 - kFriction_N - 1e-6);
  }
  EXPECT_NEAR(velocity[0], 0.0, 1e-9);
}

}  // namespace
}  // namespace torquewright::simulation
