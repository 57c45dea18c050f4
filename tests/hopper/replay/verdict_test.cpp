// SPDX-License-Identifier: Apache-2.0
// Oracle: closed forms. A robot that is turned about its pitch axis at a constant rate, and records
// that are written here row by row; no engine takes part.
#include "hopper/verdict/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hopper/replay/fall.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kTakeOff_s = 0.2;
constexpr double kPlanned_s = 0.7;
constexpr double kEnd_s = 1.0;
constexpr double kPeriod_s = 5e-4;

const simulation::GroundProfile kFlat;

const Robot& hopper_robot() {
  static const ReadRobot read = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json");
  return read.robot;
}

VectorXd pose(double pitch_rad, double height_m = 1.0) {
  VectorXd position = VectorXd::Zero(10);
  position[2] = height_m;
  position[3] = std::cos(0.5 * pitch_rad);
  position[5] = std::sin(0.5 * pitch_rad);
  return position;
}

/// Stands, turns once between take-off and touch-down, stands.
Reference one_turn() {
  Motion motion;
  constexpr int kSamples = 101;
  motion.positions.resize(10, kSamples);
  motion.velocities.setZero(9, kSamples);
  motion.accelerations.setZero(9, kSamples);
  ContactSchedule contacts;
  contacts.touches.resize(4, kSamples);
  for (int i = 0; i < kSamples; ++i) {
    const double time_s = 0.01 * i;
    const bool flies = i >= 20 && i < 70;
    motion.times_s.push_back(time_s);
    const double flown = std::clamp((time_s - kTakeOff_s) / (kPlanned_s - kTakeOff_s), 0.0, 1.0);
    motion.positions.col(i) = pose(kTurn * flown);
    if (flies) motion.velocities(4, i) = kTurn / (kPlanned_s - kTakeOff_s);
    contacts.touches.col(i).setConstant(!flies);
  }
  motion.breaks = {70};
  return Reference(hopper_robot(), motion, contacts, Eigen::MatrixXd::Zero(3, kSamples));
}

/// Turns at a share of the planned rate and touches down at a time, then stands until the end.
Record turning(double rate_share, double touch_down_s, double end_s) {
  Record record;
  record.control_period_s = kPeriod_s;
  record.step_s = 1e-4;
  const auto rows = static_cast<int>(std::lround(end_s / kPeriod_s));
  const double rate_rad_s = rate_share * kTurn / (kPlanned_s - kTakeOff_s);
  for (int i = 0; i < rows; ++i) {
    RecordRow row;
    row.time_s = kPeriod_s * i;
    const double flown_s = std::clamp(row.time_s - kTakeOff_s, 0.0, touch_down_s - kTakeOff_s);
    row.position = pose(rate_rad_s * flown_s);
    row.velocity = VectorXd::Zero(9);
    // A row's contact is that of the interval which ends with it.
    const bool flies = row.time_s > kTakeOff_s && row.time_s < touch_down_s - 1e-9;
    row.touches = TouchingPoints::Constant(4, !flies);
    record.rows.push_back(row);
  }
  record.end_s = kPeriod_s * rows;
  return record;
}

ReplayOutcome judged(const Record& record, const VerdictRule& rule) {
  const Reference motion = one_turn();
  return outcome_of(hopper_robot(), motion, flights_of(motion), record, rule);
}

TEST(ReplayVerdict, RotationShortIsThatOfTheBaseAtTouchDown) {
  const Record record = turning(0.95, 0.71, 2.0);
  const ReplayOutcome outcome = judged(record, {});
  ASSERT_TRUE(outcome.touch_down);
  EXPECT_NEAR(outcome.touch_down->time_s, 0.71, 1e-9);
  EXPECT_NEAR(outcome.touch_down->planned_s, kPlanned_s, 1e-9);
  const double turned = 0.95 * kTurn * 0.51 / 0.5;
  EXPECT_NEAR(outcome.touch_down->rotation_short_rad, kTurn - turned, 1e-9);
}

TEST(ReplayVerdict, TooMuchRotationIsNegative) {
  const ReplayOutcome outcome = judged(turning(1.1, kPlanned_s, 2.0), {});
  ASSERT_TRUE(outcome.touch_down);
  EXPECT_NEAR(outcome.touch_down->rotation_short_rad, -0.1 * kTurn, 1e-9);
}

TEST(ReplayVerdict, StandsWhereFeetRestInTheMotionsLastPosture) {
  const ReplayOutcome outcome = judged(turning(1.0, kPlanned_s, 2.0), {});
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kStands) << outcome.reason;
  EXPECT_EQ(outcome.reason, "");
  EXPECT_NEAR(outcome.foot_at_rest_s, 2.0 - kPlanned_s, 1e-9);
}

TEST(ReplayVerdict, RestInAnotherPostureIsAFall) {
  const ReplayOutcome outcome = judged(turning(0.75, kPlanned_s, 2.0), {});
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kFell);
  EXPECT_NE(outcome.reason.find("90 degrees"), std::string::npos) << outcome.reason;
}

TEST(ReplayVerdict, HoppingAndSlidingAreNotStanding) {
  const StandingRule rule;
  const auto in_the_air_at = [&](double before_end_s) {
    Record record = turning(1.0, kPlanned_s, 2.0);
    const auto back = static_cast<std::size_t>(std::lround(before_end_s / kPeriod_s));
    for (std::size_t i = 0; i <= 22; ++i) {  // 11 ms
      record.rows[record.rows.size() - back - i].touches.setConstant(false);
    }
    return judged(record, {});
  };
  EXPECT_EQ(in_the_air_at(rule.at_rest_s - 50 * kPeriod_s).verdict, ReplayVerdict::kFell);
  EXPECT_EQ(in_the_air_at(rule.at_rest_s + 2 * kPeriod_s).verdict, ReplayVerdict::kStands);
  const auto sliding_at = [&](double speed_m_s) {
    Record record = turning(1.0, kPlanned_s, 2.0);
    for (RecordRow& row : record.rows) {
      const double slid_s = std::max(0.0, row.time_s - 1.4);
      row.position[0] = speed_m_s * slid_s;
      if (slid_s > 0.0) row.slip_m_s = row.velocity[0] = speed_m_s;
    }
    return judged(record, {});
  };
  EXPECT_EQ(sliding_at(1.01 * rule.foot_speed_m_s).verdict, ReplayVerdict::kFell);
  EXPECT_EQ(sliding_at(0.99 * rule.foot_speed_m_s).verdict, ReplayVerdict::kStands);
}

// Feet to and fro by 0.5 mm at 200 Hz, 0.63 m/s at most: they go nowhere and are never at rest.
TEST(ReplayVerdict, WhatTremblesIsCalledThat) {
  Record record = turning(1.0, kPlanned_s, 2.0);
  for (RecordRow& row : record.rows) {
    const double phase_rad = kTurn * 200.0 * row.time_s;
    row.position[0] = 5e-4 * std::sin(phase_rad);
    row.slip_m_s = std::abs(0.63 * std::cos(phase_rad));
  }
  const ReplayOutcome outcome = judged(record, {});
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kTrembles) << outcome.reason;
  EXPECT_NE(outcome.reason.find("trembling"), std::string::npos) << outcome.reason;
}

TEST(ReplayVerdict, AFootInTheAirAtTheEndIsWhatIsSaid) {
  Record record = turning(1.0, kPlanned_s, 2.0);
  for (std::size_t i = 0; i < 22; ++i) {  // 11 ms
    record.rows[record.rows.size() - 1 - i].touches.setConstant(false);
  }
  const ReplayOutcome outcome = judged(record, {});
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kFell);
  EXPECT_NE(outcome.reason.find("no foot touches the ground"), std::string::npos) << outcome.reason;
}

TEST(ReplayVerdict, ABodyThatStillMovesDoesNotStand) {
  const StandingRule rule;
  Record record = turning(1.0, kPlanned_s, 2.0);
  record.rows.back().velocity[0] = 1.01 * rule.body_speed_m_s;  // of the whole robot
  EXPECT_EQ(judged(record, {}).verdict, ReplayVerdict::kTrembles);
  record.rows.back().velocity[0] = 0.99 * rule.body_speed_m_s;
  EXPECT_EQ(judged(record, {}).verdict, ReplayVerdict::kStands);
}

TEST(ReplayVerdict, WhatStoppedIsUnfinishedWhateverItLookedLike) {
  for (const RunEnd end : {RunEnd::kStopped, RunEnd::kAsked}) {
    Record record = turning(1.0, kPlanned_s, 2.0);
    record.end = end;
    record.reason = "why";
    const ReplayOutcome outcome = judged(record, {});
    EXPECT_EQ(outcome.verdict, ReplayVerdict::kUnfinished);
    EXPECT_EQ(outcome.reason, "why");
  }
  EXPECT_EQ(judged(Record{}, {}).verdict, ReplayVerdict::kUnfinished);
}

TEST(ReplayVerdict, ALossOfContactShorterThanTenMillisecondsIsNoFlight) {
  Record record = turning(1.0, kPlanned_s, 2.0);
  const auto touching_each = [&record](std::size_t rows) {
    for (std::size_t i = 0; i < record.rows.size(); ++i) {
      record.rows[i].touches.setConstant(i % rows == 0);
    }
  };
  touching_each(19);  // 9.5 ms from one to the next
  EXPECT_FALSE(judged(record, {}).touch_down);
  touching_each(21);
  EXPECT_TRUE(judged(record, {}).touch_down);
}

/// What of the robot is on the ground, straight legs at that pitch and height of its base; nothing
/// if it stands.
std::string on_the_ground(const Robot& robot, double pitch_rad, double height_m) {
  dynamics::TreeState state(robot.tree);
  state.set(pose(pitch_rad, height_m), VectorXd::Zero(9));
  return fallen(robot, state, {0.0, kFlat}).value_or("");
}

TEST(ReplayFall, BodiesThatAreNoFeetMustStayAboveTheGround) {
  Robot robot = hopper_robot();
  robot.spheres.clear();
  EXPECT_EQ(on_the_ground(robot, 0.0, 0.5), "");  // the sole is 0.01 m above the ground
  // Upside down: the thigh's centre of mass is 0.22 m below the knee.
  EXPECT_EQ(on_the_ground(robot, std::numbers::pi, 0.221), "");
  EXPECT_EQ(on_the_ground(robot, std::numbers::pi, 0.219),
            "the thigh's centre of mass is on the ground");
  EXPECT_EQ(on_the_ground(robot, std::numbers::pi / 2, -0.001),
            "the thigh's origin is on the ground");
}

// Upside down the ball of the hip ends 0.35 + 0.05 m below the knee.
TEST(ReplayFall, SoMustItsSpheres) {
  EXPECT_EQ(on_the_ground(hopper_robot(), std::numbers::pi, 0.401), "");
  EXPECT_EQ(on_the_ground(hopper_robot(), std::numbers::pi, 0.399),
            "a collision sphere of the thigh is on the ground");
}

// The sole reaches from 0.08 m behind the base to 0.12 m in front of it, 0.49 m below.
TEST(ReplayFall, WhatRunsIntoAnEdgeHasStruckIt) {
  const Robot& robot = hopper_robot();
  dynamics::TreeState state(robot.tree);
  const auto at = [&](double height_m, const simulation::GroundProfile& ground) {
    state.set(pose(0.0, height_m), VectorXd::Zero(9));
    return struck(robot, state, {0.0, ground}).value_or("");
  };
  const simulation::GroundProfile rises{{0.1}, {0.0, 0.085}}, falls{{-0.07}, {0.085, 0.0}};
  EXPECT_EQ(at(0.52, rises), "toe_left strikes an edge of the ground, 55 mm below its top");
  EXPECT_EQ(at(0.52, falls), "heel_left strikes an edge of the ground, 55 mm below its top");
  EXPECT_EQ(at(0.576, rises), "");  // over it
  EXPECT_EQ(at(0.571, rises), "");  // as deep as soft ground lets it sink
  EXPECT_EQ(at(0.47, kFlat), "");   // no edge is there
  EXPECT_EQ(at(0.52, {{0.13}, {0.0, 0.085}}), "");
  EXPECT_EQ(at(0.56, {{0.1}, {0.085, 0.0}}), "");  // below the top, further from the face
}

TEST(ReplayFall, TheDeepestPointIsNamed) {
  const Robot& robot = hopper_robot();
  dynamics::TreeState state(robot.tree);
  // Upright: all four points are 0.49 m below the knee.
  state.set(pose(0.0, 0.488), VectorXd::Zero(9));
  EXPECT_FALSE(buried(robot, state, {0.0, kFlat}, 2.1e-3));
  ASSERT_TRUE(buried(robot, state, {0.0, kFlat}, 1.9e-3));
  // Leaning forward by 0.1 rad presses the toes down.
  state.set(pose(0.1, 0.488), VectorXd::Zero(9));
  const auto point = buried(robot, state, {0.0, kFlat}, 1e-3);
  ASSERT_TRUE(point);
  EXPECT_EQ(robot.contacts[point->contact].name.substr(0, 3), "toe");
  const double depth_m = 0.49 * std::cos(0.1) + 0.12 * std::sin(0.1) - 0.488;
  EXPECT_NEAR(point->depth_m, depth_m, 1e-12);
}

}  // namespace
}  // namespace torquewright::hopper
