// SPDX-License-Identifier: Apache-2.0
// Oracle: a counter under malloc and new.
#include <gtest/gtest.h>

#include "tests/dynamics/allocation_count.hpp"
#include "tests/hopper/engines/hopper_states.hpp"

namespace torquewright::hopper {
namespace {

using test::allocation_count;
using test::EngineState;

constexpr double kStep_s = 2e-4;
constexpr int kSteps = 2000;

/// Takes memory from a run that went before, as from an earlier episode or trial.
long allocations_of(Engine& engine, const EngineState& from) {
  Eigen::VectorXd force = from.force;
  long taken = 0;
  for (int pass = 0; pass < 2; ++pass) {
    engine.start(from.position, from.velocity);
    const long before = allocation_count();
    for (int i = 0; i < kSteps; ++i) {
      test::hold(engine, from, force);
      EXPECT_EQ(engine.step(force, kStep_s), EngineOutcome::kStepped) << i;
    }
    taken = allocation_count() - before;
  }
  return taken;
}

/// With all that a step may meet: restitution, dampers, dry friction.
Robot resisting(Robot robot) {
  for (ContactPoint& contact : robot.contacts) contact.restitution = 0.1;
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    robot.tree.bodies[i].joint.passive.damping = 0.2;
    robot.tree.bodies[i].joint.passive.dry_friction = 0.3;
  }
  return robot;
}

TEST(OwnEngine, NeverAllocatesOnceItHasRun) {
  const Robot plain = test::hopper_robot();
  for (const Robot& robot : {plain, resisting(plain)}) {
    for (const EngineState& from : {test::flying(robot), test::standing(robot, 1.2),
                                    test::touching_down(robot), test::landing_on_heel(robot)}) {
      EXPECT_EQ(allocations_of(*own_engine(robot, {}), from), 0);
    }
  }
}

}  // namespace
}  // namespace torquewright::hopper
