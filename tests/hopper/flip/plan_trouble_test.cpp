// SPDX-License-Identifier: Apache-2.0
// What cannot be planned, and searches that end before they have a plan: never a plan. Oracles:
// robots and limits that rule a motion out.
#include <gtest/gtest.h>

#include "io/spec_error.hpp"
#include "tests/hopper/flip/planned.hpp"
#include "tests/hopper/flip/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

std::string refusal(const Robot& robot, const PlanOptions& options = {}) {
  try {
    const PlanResult result = plan_motion(robot, options);
    return "no refusal: " + std::string(name_of(result.status));
  } catch (const io::SpecError& error) {
    return error.what();
  }
}

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

TEST(RefusedPlan, OfARobotThatNothingPullsDown) {
  Robot robot = test::documented_robot("hopper");
  robot.tree.gravity_m_s2 = 0.0;
  EXPECT_SAYS(refusal(robot), "gravity is 0 m/s2");
}

TEST(RefusedPlan, OfARobotWhoseMassIsNeverOverItsFoot) {
  Robot robot = test::documented_robot("hopper");
  for (ContactPoint& contact : robot.contacts) contact.point.p_B_m.x() += 0.8;
  EXPECT_SAYS(refusal(robot), "cannot stand: wherever joint 'ankle_pitch' is");
  Robot leg = test::documented_robot("planar_leg");
  leg.tree.bodies[0].inertia.center_of_mass_m.x() = 0.6;
  EXPECT_SAYS(refusal(leg), "cannot stand: wherever joint 'hip' is");
}

TEST(RefusedPlan, OfAPostureBeyondTheJointsReach) {
  Robot robot = test::documented_robot("hopper");
  for (Posture& posture : robot.postures) {
    if (posture.name == "stand") posture.joints[0] = 2.26;  // The range ends at 2.2689.
  }
  EXPECT_SAYS(refusal(robot), "cannot stand: joint 'knee' would be at 2.26 rad");
}

TEST(RefusedPlan, BegunFromAnotherRobotsMotion) {
  PlanOptions options;
  options.warm = &test::planned_flip().motion;
  options.warm_file = "flip.csv";
  EXPECT_SAYS(refusal(test::documented_robot("planar_leg"), options), "motion of another robot");
}

TEST(RefusedPlan, BegunFromAnotherOrderOfContacts) {
  PlanOptions options;
  options.warm = &test::planned_flip().motion;
  options.warm_file = "flip.csv";
  options.stances = {"flat", "flight", "flat"};
  EXPECT_SAYS(refusal(test::hopper_robot_of_plans(), options), "planned is flat, flight, flat");
}

TEST(UnfinishedPlan, ForWantOfTime) {
  PlanOptions options;
  options.most_seconds = 0.01;
  const PlanResult result = plan_motion(test::hopper_robot_of_plans(), options);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_SAYS(result.reason, "0.01 s");
}

TEST(UnfinishedPlan, ForWantOfIterations) {
  PlanOptions options;
  options.most_iterations = 3;
  options.intervals = 40;
  const PlanResult result = plan_motion(test::hopper_robot_of_plans(), options);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_SAYS(result.reason, "iteration");
}

TEST(UnfinishedPlan, WhenAskedToStop) {
  PlanOptions options;
  options.should_stop = [] { return true; };
  options.intervals = 40;
  const PlanResult result = plan_motion(test::hopper_robot_of_plans(), options);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_SAYS(result.reason, "interrupted");
}

/// 4 V per ohm: at 64 ohm in all a battery of 67 V gives at most 67^2 / (4 * 64) = 18 W, and a rise
/// by half a metre takes 12.45 kg * 9.81 * 0.5 = 61 J within a push-off of less than a second.
TEST(NoPlan, OnABatteryThatCannotGiveThePower) {
  Robot robot = test::documented_robot("hopper");
  for (Drivetrain& drivetrain : robot.drivetrains) {
    for (actuator::Actuator& one : drivetrain.actuators) {
      ASSERT_TRUE(one.battery);
      one.battery->cell_resistance_ohm = 16.0;
    }
  }
  PlanOptions options;
  options.task = &tasks::jump;
  options.rise_m = 0.5;
  options.intervals = 40;
  options.most_seconds = 15.0;
  const PlanResult result = plan_motion(robot, options);
  EXPECT_NE(result.status, PlanStatus::kPlanned);
  EXPECT_NE(result.reason, "");
}

}  // namespace
}  // namespace torquewright::hopper
