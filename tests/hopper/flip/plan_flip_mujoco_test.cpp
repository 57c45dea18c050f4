// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo, on the planned flip itself.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/inverse_dynamics.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/tree_mjcf.hpp"
#include "tests/hopper/flip/planned.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using test::hopper_robot_of_plans;
using test::planned_flip;

class FlipBesideMujoco : public testing::Test {
 protected:
  TreeMotion tree(const PlannedPhase& phase, const PlannedInstant& at) const {
    return tree_motion(plane, phase.frame(), {at.position, at.velocity, at.acceleration});
  }
  VectorXd theirs(const TreeMotion& at) {
    mujoco.set(at.position, at.velocity);
    return mujoco.inverse_dynamics(at.acceleration);
  }

  SagittalRobot plane = sagittal(hopper_robot_of_plans());
  test::MujocoEngine mujoco{test::mjcf_of(plane.robot.tree)};
};

TEST_F(FlipBesideMujoco, InverseDynamicsOfTheMotionAreAlike) {
  dynamics::TreeState state(plane.robot.tree);
  for (const PlannedPhase& phase : planned_flip().plan.phases) {
    for (const PlannedInstant& instant : phase.instants) {
      const TreeMotion at = tree(phase, instant);
      VectorXd ours(plane.robot.tree.velocity_size());
      state.set(at.position, at.velocity);
      dynamics::inverse_dynamics(state, at.acceleration, ours);
      const VectorXd other = theirs(at);
      EXPECT_LE((ours - other).cwiseAbs().maxCoeff(), 1e-9 * other.cwiseAbs().maxCoeff())
          << instant.time_s;
    }
  }
}

/// Nothing but the ground pushes the robot as a whole. The planner's rows are met to 1e-6 of 100 N.
TEST_F(FlipBesideMujoco, TheGroundGivesWhatTheMotionTakes) {
  constexpr double kMet_N = 2e-4;
  for (const PlannedPhase& phase : planned_flip().plan.phases) {
    for (const PlannedInstant& instant : phase.instants) {
      const VectorXd needed = theirs(tree(phase, instant));
      const Eigen::Vector3d given_N = instant.contact_N.rowwise().sum();
      EXPECT_NEAR(needed[0], given_N.x(), kMet_N) << instant.time_s;
      EXPECT_NEAR(needed[1], given_N.z(), kMet_N) << instant.time_s;
    }
  }
}

TEST_F(FlipBesideMujoco, StandsWhenItIsReplayed) {
  const ReplayResult run = test::replayed(hopper_robot_of_plans(), planned_flip(), engines::mujoco);
  EXPECT_EQ(run.outcome.verdict, ReplayVerdict::kStands) << run.outcome.reason;
  // A degree, and what the base turns (9 rad/s) while ground of 1 ms gives way.
  ASSERT_TRUE(run.outcome.touch_down);
  EXPECT_LT(std::abs(run.outcome.touch_down->rotation_short_rad), test::kDegree_rad + 9.0 * 1e-3);
}

}  // namespace
}  // namespace torquewright::hopper
