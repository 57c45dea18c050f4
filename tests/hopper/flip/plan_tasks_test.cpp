// SPDX-License-Identifier: Apache-2.0
// Jumps and hops of two robots, plans in boxes and from other guesses. Oracles: `hopper check` of
// the motion; kinematics of its samples; energy, which a rise takes.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/hopper/flip/planned.hpp"
#include "tests/hopper/flip/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

// A sample of the motion is up to half a step of 1 ms from the highest point: g (0.5 ms)^2 / 2.
constexpr double kRise_m = 2e-6;
constexpr double kPlace_m = 1e-6;

struct Task {
  const char* name;
  const char* robot;
  const PlanTask* task;
  double rise_m;
  double stride_m;
};

class PlannedTask : public testing::TestWithParam<Task> {};

TEST_P(PlannedTask, RisesAndLandsWhereItIsToAndTheCheckPassesIt) {
  const Task& task = GetParam();
  const Robot robot = test::documented_robot(task.robot);
  PlanOptions options;
  options.task = task.task;
  options.rise_m = task.rise_m;
  options.stride_m = task.stride_m;
  options.intervals = 60;
  const PlanResult result = plan_motion(robot, options);
  ASSERT_EQ(result.status, PlanStatus::kPlanned) << result.reason;
  EXPECT_EQ(test::checked(robot, result).check.verdict, actuator::Verdict::kPass);
  EXPECT_GE(test::rise_m(robot, result), task.rise_m - kRise_m);
  for (std::size_t contact = 0; contact < robot.contacts.size(); ++contact) {
    const Eigen::Vector3d moved_m = test::moved_m(robot, result, contact);
    EXPECT_NEAR(moved_m.x(), task.task == &tasks::hop ? task.stride_m : 0.0, kPlace_m);
    EXPECT_NEAR(moved_m.z(), 0.0, kPlace_m);
  }
}

INSTANTIATE_TEST_SUITE_P(, PlannedTask,
                         testing::Values(Task{"JumpOfTheHopper", "hopper", &tasks::jump, 0.15, 0.0},
                                         Task{"HopOfTheHopper", "hopper", &tasks::hop, 0.1, 0.2},
                                         Task{"JumpOfTheLeg", "planar_leg", &tasks::jump, 0.12,
                                              0.0}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(PlannedLeg, StandsOnItsPointWithALevelBase) {
  const Robot robot = test::documented_robot("planar_leg");
  PlanOptions options;
  options.task = &tasks::jump;
  options.intervals = 60;
  const PlanResult result = plan_motion(robot, options);
  ASSERT_EQ(result.status, PlanStatus::kPlanned) << result.reason;
  const Eigen::Index last = result.motion.samples() - 1;
  for (const Eigen::Index sample : {Eigen::Index(0), last}) {
    EXPECT_NEAR(result.motion.positions(2, sample), 0.0, 1e-6);  // pitch of a planar base
    EXPECT_LT(result.motion.velocities.col(sample).cwiseAbs().maxCoeff(), 1e-6);
  }
}

}  // namespace
}  // namespace torquewright::hopper
