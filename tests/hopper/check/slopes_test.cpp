// SPDX-License-Identifier: Apache-2.0
// Oracles: parabolas, whose slopes and curvatures are known, and a body that turns at constant
// speed about a fixed axis.
#include "hopper/motion/slopes.hpp"

#include <gtest/gtest.h>

#include "dynamics/position_step.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

dynamics::Tree arm(dynamics::BaseKind base) {
  dynamics::Tree tree;
  tree.base = base;
  dynamics::Body body;
  body.inertia.mass_kg = 1;
  body.inertia.inertia_kg_m2.setIdentity();
  tree.bodies = {body, body};
  tree.bodies[1].joint.name = "elbow";
  return tree;
}

Motion positions_only(const dynamics::Tree& tree, const std::vector<double>& times_s) {
  Motion motion;
  motion.times_s = times_s;
  motion.positions.setZero(tree.position_size(), motion.samples());
  motion.velocity_origin = Origin::kAbsent;
  motion.acceleration_origin = Origin::kAbsent;
  return motion;
}

TEST(Slopes, AreExactForParabolasOnUnevenSteps) {
  const dynamics::Tree tree = arm(dynamics::BaseKind::kPlanar);
  Motion motion = positions_only(tree, {0, 0.1, 0.25, 0.3, 0.7});
  for (Index i = 0; i < motion.samples(); ++i) {
    const double t = motion.time_s(i);
    motion.positions.col(i) << 1 + t, 2 - 3 * t * t, t * t, 4 * t - t * t;
  }
  derive_rates(tree, motion);
  for (Index i = 0; i < motion.samples(); ++i) {
    const double t = motion.time_s(i);
    EXPECT_LE((motion.velocities.col(i) - Eigen::Vector4d(1, -6 * t, 2 * t, 4 - 2 * t)).norm(),
              1e-12);
    EXPECT_LE((motion.accelerations.col(i) - Eigen::Vector4d(0, -6, 2, -2)).norm(), 1e-11);
  }
  EXPECT_EQ(motion.velocity_origin, Origin::kDerived);
}

TEST(Slopes, DoNotLookAcrossAnImpact) {
  const dynamics::Tree tree = arm(dynamics::BaseKind::kFixed);
  Motion motion = positions_only(tree, {0, 1, 2, 3, 4, 5});
  motion.positions << 0, -1, -2, -1, 0, 1;  // a kink at 2
  motion.breaks = {3};
  derive_rates(tree, motion);
  EXPECT_EQ(motion.velocities(0, 2), -1);
  EXPECT_EQ(motion.velocities(0, 3), 1);
  EXPECT_TRUE(motion.accelerations.isZero(0));
}

TEST(Slopes, OfARotationAreItsAngularVelocityInTheBodysAxes) {
  const dynamics::Tree tree = arm(dynamics::BaseKind::kSpatial);
  Motion motion = positions_only(tree, {0, 0.1, 0.2, 0.3});
  VectorXd velocity(7);
  velocity << 1, 2, 3, 0.4, -0.5, 2.0, 0.7;
  VectorXd position = dynamics::zero_position(tree);
  position.segment<4>(3) << 0.5, -0.5, 0.5, 0.5;
  for (Index i = 0; i < motion.samples(); ++i) {
    dynamics::step_position(tree, position, velocity, motion.time_s(i), motion.positions.col(i));
  }
  motion.positions.col(2).segment<4>(3) *= -1;  // the same rotation
  derive_rates(tree, motion);
  for (Index i = 0; i < motion.samples(); ++i) {
    EXPECT_LE((motion.velocities.col(i) - velocity).norm(), 1e-12);
    EXPECT_LE(motion.accelerations.col(i).norm(), 1e-11);
  }
}

}  // namespace
}  // namespace torquewright::hopper
