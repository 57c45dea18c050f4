// SPDX-License-Identifier: Apache-2.0
// Oracles: closed forms of a damper, a spring and dry friction; their derivatives in closed form.
#include "dynamics/passive_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/jet.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

/// A hinge with everything and a slide behind it with dry friction alone.
Tree two_joints() {
  Tree tree;
  tree.bodies.resize(3);
  tree.bodies[1].joint.passive = {0.4, 1.5, 2.0, 30.0, 0.1};
  tree.bodies[2].parent = 1;
  tree.bodies[2].joint.kind = JointKind::kPrismatic;
  tree.bodies[2].joint.passive.dry_friction = 7.0;
  return tree;
}

TreeState at(const Vector2d& position, const Vector2d& velocity) {
  TreeState state(two_joints());
  state.set(position, velocity);
  return state;
}

TEST(PassiveForces, DampersAndSpringsFollowTheirLaws) {
  VectorXd force = VectorXd::Constant(2, 5.0);
  add_dampers_and_springs(at({0.3, 9.0}, {-2.0, 4.0}), force);
  EXPECT_NEAR(force[0], 5.0 + 0.4 * -2.0 + 30.0 * (0.3 - 0.1), 1e-14);
  EXPECT_EQ(force[1], 5.0);
}

TEST(PassiveForces, DryFrictionIsAgainstTheMotionOrItsBeginning) {
  const VectorXd none = VectorXd::Zero(2);
  VectorXd force = none;
  add_dry_friction(at({0, 0}, {-1e-3, 2.0}), none, force);
  EXPECT_EQ(force, Vector2d(-1.5, 7.0));
  force = none;  // at rest, and about to move
  add_dry_friction(at({0, 0}, {0, 0}), Vector2d(3.0, -1.0), force);
  EXPECT_EQ(force, Vector2d(1.5, -7.0));
  force = none;  // at rest to stay
  add_dry_friction(at({0, 0}, {0, 0}), none, force);
  EXPECT_EQ(force, none);
}

TEST(PassiveForces, FrictionHoldsUpToItsStaticLimit) {
  const VectorXd none = VectorXd::Zero(2);
  VectorXd held(2);
  held_by_friction(at({0, 0}, {0, 0}), none, Vector2d(1.9, -9.0), held);
  EXPECT_EQ(held, Vector2d(1.9, -7.0));
  held_by_friction(at({0, 0}, {0, 0}), none, Vector2d(-2.5, 0.0), held);
  EXPECT_EQ(held, Vector2d(-2.0, 0.0));
  held_by_friction(at({0, 0}, {0.1, 0}), none, Vector2d(1.0, 3.0), held);  // the first moves
  EXPECT_EQ(held, Vector2d(0.0, 3.0));
}

// d/dv of f v/sqrt(v^2 + w^2) is f w^2/(v^2 + w^2)^(3/2).
TEST(PassiveForces, SmoothFrictionHasItsSlope) {
  constexpr double kWidth = 0.05, kSpeed = 0.08;
  const auto friction_at = [](double speed) {
    VectorXd force = VectorXd::Zero(2);
    add_smooth_friction(at({0, 0}, {speed, 0}), kWidth, force);
    return force[0];
  };
  EXPECT_NEAR(friction_at(10 * kWidth), 1.5, 0.005 * 1.5);
  EXPECT_EQ(friction_at(0.0), 0.0);
  constexpr double kStep = 1e-5;
  const double slope = (friction_at(kSpeed + kStep) - friction_at(kSpeed - kStep)) / (2 * kStep);
  const double root = std::hypot(kSpeed, kWidth);
  EXPECT_NEAR(slope, 1.5 * kWidth * kWidth / (root * root * root), 1e-6);
}

TEST(PassiveForces, OfNoNumberOrBelowZeroMakeNoTree) {
  for (const double wrong : {-1.0, std::nan("")}) {
    Tree tree = two_joints();
    tree.bodies[1].joint.passive.damping = wrong;
    EXPECT_THROW(require_tree(tree), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace torquewright::dynamics
