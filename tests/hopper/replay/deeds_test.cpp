// SPDX-License-Identifier: Apache-2.0
// Oracle: closed forms. Parabolas of free flight and ways that are written down row by row; no
// engine takes part.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "dynamics/gravity.hpp"
#include "hopper/verdict/goal.hpp"
#include "hopper/verdict/verdict.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kSample_s = 5e-4;
constexpr double kWatched_s = 1.0;
constexpr Index kKnee = 7;  ///< The first joint's place in a position.

const Robot& deed_robot() {
  static const ReadRobot read = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json");
  return read.robot;
}

/// A hop: in the air from one time on for another, and so far forward in that time.
struct Hop {
  double from_s = 0.3;
  double lasts_s = 0.3;
  double forward_m = 0.1;
};

/// Upright all the time; each hop a parabola.
struct Course {
  std::vector<Hop> hops = std::vector<Hop>(1);
  double ends_s = 1.5;
  double last_knee_rad = 0.0;
  double dips_m = 0.0;  ///< In the shape of half a sine over the first 0.2 s.

  bool flies(double time_s) const {
    return std::any_of(hops.begin(), hops.end(), [time_s](const Hop& hop) {
      return time_s > hop.from_s + 1e-9 && time_s < hop.from_s + hop.lasts_s - 1e-9;
    });
  }

  VectorXd position(double time_s) const {
    VectorXd position = VectorXd::Zero(10);
    position[2] = 1.0;
    position[3] = 1.0;
    for (const Hop& hop : hops) {
      const double flown_s = std::clamp(time_s - hop.from_s, 0.0, hop.lasts_s);
      if (hop.lasts_s > 0.0) position[0] += hop.forward_m * flown_s / hop.lasts_s;
      position[2] += 0.5 * dynamics::kGravity_m_s2 * flown_s * (hop.lasts_s - flown_s);
    }
    if (time_s < 0.2) position[2] -= dips_m * std::sin(M_PI * time_s / 0.2);
    position[kKnee] = last_knee_rad * std::clamp(time_s / ends_s, 0.0, 1.0);
    return position;
  }
};

Reference motion_of(const Course& course) {
  Motion motion;
  const auto samples = static_cast<Index>(std::lround(course.ends_s / kSample_s)) + 1;
  motion.positions.resize(10, samples);
  motion.velocities.setZero(9, samples);
  motion.accelerations.setZero(9, samples);
  ContactSchedule contacts;
  contacts.touches.resize(4, samples);
  for (Index i = 0; i < samples; ++i) {
    const double time_s = kSample_s * static_cast<double>(i);
    motion.times_s.push_back(time_s);
    motion.positions.col(i) = course.position(time_s);
    if (i > 0) {
      motion.velocities.col(i).head<3>() =
          (motion.positions.col(i) - motion.positions.col(i - 1)).head<3>() / kSample_s;
    }
    contacts.touches.col(i).setConstant(!course.flies(time_s));
  }
  return Reference(deed_robot(), motion, contacts, Eigen::MatrixXd::Zero(3, samples));
}

Record run_of(const Course& course) {
  Record record;
  record.control_period_s = record.step_s = kSample_s;
  record.end_s = course.ends_s + kWatched_s;
  const auto rows = std::lround(record.end_s / kSample_s);
  for (long i = 0; i < rows; ++i) {
    RecordRow& row = record.rows.emplace_back();
    row.time_s = kSample_s * static_cast<double>(i);
    row.position = course.position(row.time_s);
    row.velocity = VectorXd::Zero(9);
    row.touches = TouchingPoints::Constant(4, !course.flies(row.time_s));
  }
  return record;
}

ReplayOutcome judged(const Course& planned, const Course& done, const DeedTolerances& within = {}) {
  const Reference motion = motion_of(planned);
  return outcome_of(deed_robot(), motion, flights_of(motion), run_of(done), {{}, within});
}

/// The first deed of a name, or that of one of its owners.
const Deed& deed_named(const ReplayOutcome& outcome, const std::string& name,
                       const std::string& of = "") {
  const auto found = std::find_if(
      outcome.deeds.begin(), outcome.deeds.end(),
      [&](const Deed& deed) { return deed.name == name && (of.empty() || deed.of == of); });
  if (found == outcome.deeds.end()) throw std::runtime_error("no deed is called " + name);
  return *found;
}

TEST(ReplayDeeds, WhatIsDoneAsPlannedIsDone) {
  const ReplayOutcome outcome = judged({}, {});
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kStands) << outcome.reason;
  // The motion's flight begins with its first sample in the air, one after the last contact.
  const Deed& flight = deed_named(outcome, "flight");
  EXPECT_NEAR(flight.planned, 0.3 - kSample_s, 1e-9);
  EXPECT_NEAR(flight.done, 0.3, 1e-9);
  const Deed& rise = deed_named(outcome, "rise");
  const double rise_m = dynamics::kGravity_m_s2 * 0.3 * 0.3 / 8.0;
  EXPECT_NEAR(rise.planned, rise_m, 1e-9);
  EXPECT_NEAR(rise.done, rise_m, 1e-9);
  const Deed& landing = deed_named(outcome, "landing");
  EXPECT_NEAR(landing.planned, 0.1, 1e-9);
  EXPECT_NEAR(landing.off, 0.0, 1e-9);
}

// The hop that was never made: half a millisecond of flight, no way.
TEST(ReplayDeeds, AHopThatIsNotMadeIsMissedHoweverWellItStands) {
  Course stays;
  stays.hops = {{0.3, 0.001, 0.0}};
  const ReplayOutcome outcome = judged({}, stays);
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kMissed);
  EXPECT_FALSE(outcome.touch_down);
  EXPECT_NEAR(deed_named(outcome, "flight").done, 0.001, 1e-9);
  EXPECT_NEAR(deed_named(outcome, "landing").off, 0.1, 1e-9);
  EXPECT_NE(outcome.reason.find("1.0 of 299.5 ms"), std::string::npos) << outcome.reason;
  Course never;
  never.hops = {};
  EXPECT_EQ(judged({}, never).verdict, ReplayVerdict::kMissed);
}

TEST(ReplayDeeds, AFlightMayBeOffByItsShareToEitherSide) {
  const auto verdict_at = [](double lasts_s) {
    Course other;
    other.hops[0].lasts_s = lasts_s;
    return judged({}, other).verdict;
  };
  EXPECT_EQ(verdict_at(0.3 * 0.76), ReplayVerdict::kStands);
  EXPECT_EQ(verdict_at(0.3 * 0.74), ReplayVerdict::kMissed);
  // A rise goes with the square: 1.5 of it is 1.2247 of the time.
  EXPECT_EQ(verdict_at(0.3 * 1.22), ReplayVerdict::kStands);
  EXPECT_EQ(verdict_at(0.3 * 1.24), ReplayVerdict::kMissed);
}

TEST(ReplayDeeds, FeetMayLandBesideTheirPlaceByDistanceAndShareOfTheWay) {
  const auto verdict_at = [](double forward_m) {
    Course other;
    other.hops[0].forward_m = forward_m;
    return judged({}, other).verdict;
  };
  const double allowed_m = 0.05 + 0.25 * 0.1;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_EQ(verdict_at(0.1 + side * 0.99 * allowed_m), ReplayVerdict::kStands);
    EXPECT_EQ(verdict_at(0.1 + side * 1.01 * allowed_m), ReplayVerdict::kMissed);
  }
}

// Where heights say what touches, a foot is seen to rise 15 ms after the ground's force ended.
TEST(ReplayDeeds, TakeOffIsThatOfTheCheck) {
  Course seen_late;
  seen_late.hops = {{0.315, 0.285, 0.1}, {0.9, 0.3, 0.0}};
  const Reference motion = motion_of(seen_late);
  Flight checked;
  checked.from_s = 0.3;
  checked.until_s = 0.6;
  const std::vector<TimeInAir> flights = flights_of(motion, {checked});
  ASSERT_EQ(flights.size(), 2u);
  EXPECT_DOUBLE_EQ(flights[0].from_s, 0.3);
  EXPECT_DOUBLE_EQ(flights[0].until_s, flights_of(motion)[0].until_s);
  EXPECT_DOUBLE_EQ(flights[1].from_s, flights_of(motion)[1].from_s);
}

// The second landing is compared with the second, not with the longest of all.
TEST(ReplayDeeds, EachLandingIsComparedWithItsOwn) {
  Course planned, done;
  planned.hops = {{0.3, 0.30, 0.1}, {0.9, 0.29, 0.1}};
  done.hops = {{0.3, 0.28, 0.1}, {0.9, 0.30, 0.1}};
  const ReplayOutcome outcome = judged(planned, done);
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kStands) << outcome.reason;
  ASSERT_EQ(outcome.landings.size(), 2u);
  EXPECT_NEAR(outcome.landings[0].time_s, 0.58, 1e-9);
  EXPECT_NEAR(outcome.landings[0].planned_s, 0.60, 1e-9);
  EXPECT_NEAR(outcome.landings[1].time_s, 1.20, 1e-9);
  EXPECT_NEAR(outcome.landings[1].planned_s, 1.19, 1e-9);
  ASSERT_TRUE(outcome.touch_down);  // of the longest in the motion
  EXPECT_NEAR(outcome.touch_down->planned_s, 0.60, 1e-9);
}

TEST(ReplayDeeds, AHopThatIsLeftOutIsNamed) {
  Course planned, done;
  planned.hops = {{0.3, 0.3, 0.1}, {0.9, 0.3, 0.1}};
  done.hops = {{0.9, 0.3, 0.2}};
  const ReplayOutcome outcome = judged(planned, done);
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kMissed);
  EXPECT_FALSE(deed_named(outcome, "flight", "flight 1").is_done);
  EXPECT_TRUE(deed_named(outcome, "flight", "flight 2").is_done);
  EXPECT_TRUE(deed_named(outcome, "last_place").is_done);
}

// A bounce after the landing, and a touch in the first milliseconds, are not the flight.
TEST(ReplayDeeds, BouncesAndChatterAreNotTakenForTheFlight) {
  Course bounces;
  bounces.hops = {{0.29, 0.004, 0.0}, {0.3, 0.3, 0.1}, {0.63, 0.03, 0.0}};
  const ReplayOutcome outcome = judged({}, bounces);
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kStands) << outcome.reason;
  ASSERT_TRUE(outcome.touch_down);
  EXPECT_NEAR(outcome.touch_down->time_s, 0.6, 1e-9);
}

// A whole turn that was left out leaves the posture as it should be.
TEST(ReplayDeeds, ATurnThatIsLeftOutIsMissedThoughThePostureIsRight) {
  const Course course;
  Record turned = run_of(course);
  for (RecordRow& row : turned.rows) {
    const double half_rad = M_PI * std::clamp((row.time_s - 0.3) / 0.3, 0.0, 1.0);
    row.position[3] = std::cos(half_rad);
    row.position[5] = std::sin(half_rad);
  }
  const Reference motion = motion_of(course);
  const ReplayOutcome outcome = outcome_of(deed_robot(), motion, flights_of(motion), turned, {});
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kMissed);
  const Deed& rotation = deed_named(outcome, "rotation");
  EXPECT_NEAR(rotation.planned, 0.0, 1e-9);
  EXPECT_NEAR(rotation.done, 2.0 * M_PI, 1e-9);
}

TEST(ReplayDeeds, ASquatMustGoDown) {
  Course squats, stays;
  squats.hops = stays.hops = {};
  squats.dips_m = 0.2;
  const ReplayOutcome outcome = judged(squats, stays);
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kMissed);
  EXPECT_NEAR(deed_named(outcome, "dip").planned, 0.2, 1e-6);
  EXPECT_NEAR(deed_named(outcome, "dip").done, 0.0, 1e-9);
  EXPECT_EQ(judged(squats, squats).verdict, ReplayVerdict::kStands);
  Course deeper = squats;
  deeper.dips_m = 0.4;
  EXPECT_EQ(judged(squats, deeper).verdict, ReplayVerdict::kStands);
}

TEST(ReplayDeeds, TheJointThatIsFarthestOffIsNamed) {
  Course planned, sank;
  sank.last_knee_rad = 0.31;
  const ReplayOutcome outcome = judged(planned, sank);
  EXPECT_EQ(outcome.verdict, ReplayVerdict::kMissed);
  EXPECT_EQ(deed_named(outcome, "last_posture").of, "knee");
  DeedTolerances wider;
  wider.joint_rad = 0.32;
  wider.place_m = 0.2;  // the leg leans: 0.49 m sin(0.31)
  EXPECT_EQ(judged(planned, sank, wider).verdict, ReplayVerdict::kStands);
}

/// Turned about the vertical, as far as it has hopped.
Record turned(Record record, double turn_rad) {
  const double cosine = std::cos(turn_rad), sine = std::sin(turn_rad);
  for (RecordRow& row : record.rows) {
    row.position.head<2>() = Eigen::Vector2d(cosine * row.position[0], sine * row.position[0]);
    row.position[3] = std::cos(0.5 * turn_rad);
    row.position[6] = std::sin(0.5 * turn_rad);
  }
  return record;
}

// From the first landing, at 0.6 s, to the last, at 1.4 s, it goes 0.2 m its own way.
TEST(ReplayDeeds, HopsAtACommandedSpeedAreJudgedByItWhicheverWayTheyFace) {
  Course course;
  course.hops = {{0.3, 0.3, 0.1}, {0.7, 0.3, 0.1}, {1.1, 0.3, 0.1}};
  course.ends_s = 2.0;
  const Reference ends = motion_of(course);
  Goal goal;
  goal.least_flights = goal.most_flights = 3;
  goal.landings_s = {0.6, 1.0, 1.4};
  for (const double turn_rad : {0.0, 1.2}) {
    for (const auto& [commanded_m_s, verdict] :
         {std::pair{0.3, ReplayVerdict::kStands}, {0.4, ReplayVerdict::kMissed}}) {
      goal.forward_m_s = commanded_m_s;
      const ReplayOutcome outcome =
          outcome_of(deed_robot(), ends, goal, turned(run_of(course), turn_rad), {});
      const Deed& speed = deed_named(outcome, "hopping_speed");
      EXPECT_NEAR(speed.done, 0.25, 1e-9);
      EXPECT_NEAR(speed.off, commanded_m_s - 0.25, 1e-9);
      EXPECT_NEAR(deed_named(outcome, "heading").done, turn_rad, 1e-9);
      EXPECT_EQ(outcome.verdict, verdict) << outcome.reason;
      EXPECT_NEAR(outcome.landings.back().planned_s, 1.4, 1e-12);
    }
  }
}

/// At the end leaning sideways by an angle, then turned about the vertical by another.
Record ends_leaning(double lean_rad, double turn_rad) {
  Record record = run_of({});
  const Eigen::Quaterniond attitude =
      Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()) *
      Eigen::Quaterniond(Eigen::AngleAxisd(lean_rad, Eigen::Vector3d::UnitX()));
  for (RecordRow& row : record.rows) {
    if (row.time_s < 1.4) continue;
    row.position.segment<4>(3) << attitude.w(), attitude.x(), attitude.y(), attitude.z();
  }
  return record;
}

// A robot that faces elsewhere has not fallen, however far it is turned; one that leans has.
TEST(ReplayDeeds, WhichWayItFacesIsADeedAndHowFarItLeansIsAFall) {
  const auto judge = [](double lean_rad, double turn_rad, const DeedTolerances& within) {
    const Reference motion = motion_of({});
    return outcome_of(deed_robot(), motion, flights_of(motion), ends_leaning(lean_rad, turn_rad),
                      {{}, within});
  };
  DeedTolerances anywhere;
  anywhere.place_m = 1.0;
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(judge(0.45, 0.45 * sign, anywhere).verdict, ReplayVerdict::kStands);
    EXPECT_EQ(judge(0.55, 0.0, anywhere).verdict, ReplayVerdict::kFell);
    for (const double turn_rad : {0.6, 1.7, 3.0}) {
      const ReplayOutcome outcome = judge(0.2, turn_rad * sign, anywhere);
      EXPECT_EQ(outcome.verdict, ReplayVerdict::kMissed);
      EXPECT_NEAR(deed_named(outcome, "heading").done, turn_rad * sign, 1e-9);
      anywhere.heading_rad = 3.1;
      EXPECT_EQ(judge(0.2, turn_rad * sign, anywhere).verdict, ReplayVerdict::kStands);
      anywhere.heading_rad = 0.5;
    }
  }
}

}  // namespace
}  // namespace torquewright::hopper
