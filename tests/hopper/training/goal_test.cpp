// SPDX-License-Identifier: Apache-2.0
// Oracle: closed forms. Records written here row by row: a robot on a planar base that turns at a
// constant rate while it flies; no engine takes part.
#include "hopper/verdict/goal.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "hopper/training/task/task_ends.hpp"
#include "hopper/training/task/task_spec.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kWhole = 2.0 * std::numbers::pi;
constexpr double kLook_s = 0.002;

const ReadyTask& flip_task() {
  static const ReadRobot read = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json");
  static const ReadyTask ready = ready_task(read.robot, read_task("hopper_flip"));
  return ready;
}

/// Stands but for two stretches in the air, turning evenly in the first; until 3 s.
Record flown(double turn_rad, TimeInAir first, TimeInAir second = {}) {
  Record record;
  record.step_s = record.control_period_s = kLook_s;
  const ReadyTask& ready = flip_task();
  const auto points = static_cast<Eigen::Index>(ready.robot.contacts.size());
  for (int i = 0; i < 1500; ++i) {
    RecordRow row;
    row.time_s = kLook_s * i;
    row.position = ready.start_position;
    row.velocity = Eigen::VectorXd::Zero(ready.robot.tree.velocity_size());
    const double share = (row.time_s - first.from_s) / first.duration_s();
    row.position[2] += turn_rad * std::clamp(share, 0.0, 1.0);
    const auto is_in = [&](const TimeInAir& air) {
      return row.time_s > air.from_s + 1e-9 && row.time_s < air.until_s - 1e-9;
    };
    row.touches = TouchingPoints::Constant(points, !is_in(first) && !is_in(second));
    record.rows.push_back(row);
  }
  record.end_s = 3.0;
  return record;
}

ReplayOutcome judged_goal(const Record& record) {
  const ReadyTask& ready = flip_task();
  return outcome_of(ready.robot, reference_of_ends(ready), ready.task.goal, record, VerdictRule{});
}

TEST(GoalVerdict, OneTurnInOneFlightAndRestIsSuccess) {
  const ReplayOutcome outcome = judged_goal(flown(kWhole, {0.5, 1.0}));
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kStands) << outcome.reason;
  ASSERT_TRUE(outcome.touch_down);
  EXPECT_NEAR(outcome.touch_down->time_s, 1.0, 1e-9);
  EXPECT_NEAR(outcome.touch_down->rotation_short_rad, 0.0, 1e-9);
}

TEST(GoalVerdict, SaysByHowMuchATurnIsShort) {
  // 0.45 rad are within both tolerances (0.5 rad), 0.55 rad are a posture that is not the end's.
  EXPECT_EQ(judged_goal(flown(kWhole - 0.45, {0.5, 1.0})).verdict, ReplayVerdict::kStands);
  const ReplayOutcome outcome = judged_goal(flown(kWhole - 0.55, {0.5, 1.0}));
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kFell);
  ASSERT_TRUE(outcome.touch_down);
  EXPECT_NEAR(outcome.touch_down->rotation_short_rad, 0.55, 1e-9);
  EXPECT_NE(outcome.reason.find("32 degrees"), std::string::npos) << outcome.reason;
}

TEST(GoalVerdict, NoTurnAtAllIsNoFlipThoughItStands) {
  const ReplayOutcome outcome = judged_goal(flown(0.0, {0.5, 1.0}));
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kMissed);
  EXPECT_NE(outcome.reason.find("0.0 of 360.0 degrees"), std::string::npos) << outcome.reason;
}

TEST(GoalVerdict, ASecondFlightIsNotLandingAndChatterIsNone) {
  EXPECT_EQ(judged_goal(flown(kWhole, {0.5, 1.0}, {1.2, 1.35})).verdict, ReplayVerdict::kMissed);
  EXPECT_EQ(judged_goal(flown(kWhole, {0.5, 1.0}, {1.2, 1.29})).verdict, ReplayVerdict::kStands);
}

TEST(GoalVerdict, FeetThatDoNotRestAreNoStanding) {
  Record record = flown(kWhole, {0.5, 1.0});
  for (RecordRow& row : record.rows) {
    if (row.time_s > 2.8) row.slip_m_s = 0.3;
  }
  EXPECT_NE(judged_goal(record).verdict, ReplayVerdict::kStands);
}

TEST(GoalVerdict, AFallKeepsItsReasonAndItsTime) {
  Record record = flown(kWhole, {0.5, 1.0});
  record.rows.resize(600);
  record.end = RunEnd::kFell;
  record.end_s = 1.2;
  record.reason = "the thigh is on the ground";
  const ReplayOutcome outcome = judged_goal(record);
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kFell);
  EXPECT_EQ(outcome.reason, "the thigh is on the ground");
  EXPECT_EQ(outcome.end_s, 1.2);
}

}  // namespace
}  // namespace torquewright::hopper
