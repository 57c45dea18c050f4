// SPDX-License-Identifier: Apache-2.0
// States on the way through the hand-made flip. Oracle: the motion's own rows on the robot in three
// dimensions, by forward kinematics there; and what is known of that motion: it turns once, and
// its feet are clear of the ground from 0.641 to 1.134 s (worked out apart from its rows).
#include "hopper/training/episode/mid_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "hopper/check/hopper_check.hpp"
#include "hopper/engines/library.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/motion/slopes.hpp"
#include "hopper/training/episode/hopper_environment.hpp"
#include "hopper/training/task/task_spec.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

struct Flip {
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  Motion motion = read("hopper_flip");
  TimeInAir flight = flight_of(ready_task(robot, read_task("hopper_flip")), motion);
  ReadyTask ready =
      ready_task(robot, with_flight(read_task("hopper_flip"), flight.from_s, flight.until_s));
  std::vector<MidState> states = mid_states(ready, motion);

  Motion read(const std::string& name) const {
    MotionFile source;
    source.file = TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/" + name + ".csv";
    Motion read = read_motion(robot, source);
    derive_rates(robot.tree, read);
    return read;
  }
};

const Flip& flip() {
  static const Flip made;
  return made;
}

double lowest_m(const Robot& robot, dynamics::TreeState& state) {
  double least_m = 1e9;
  for (const ContactPoint& contact : robot.contacts) {
    least_m = std::min(least_m, dynamics::point_position_m(state, contact.point).z());
  }
  return least_m;
}

TEST(MidMotion, IsTheMotionInThePlane) {
  const Flip& of = flip();
  dynamics::TreeState plane(of.ready.robot.tree), space(of.robot.tree);
  ASSERT_GT(of.states.size(), 50u);
  std::size_t sample = 0;
  for (const MidState& state : of.states) {
    while (of.motion.positions.col(static_cast<Eigen::Index>(sample))[2] != state.position[1]) {
      ASSERT_LT(++sample, of.motion.times_s.size()) << "no row of the motion is that high";
    }
    const auto row = static_cast<Eigen::Index>(sample);
    plane.set(state.position, state.velocity);
    space.set(of.motion.positions.col(row), of.motion.velocities.col(row));
    EXPECT_NEAR(lowest_m(of.ready.robot, plane), lowest_m(of.robot, space), 1e-9);
    EXPECT_NEAR(dynamics::centroid(plane).angular_momentum_Nm_s.y(),
                dynamics::centroid(space).angular_momentum_Nm_s.y(), 1e-7);
  }
}

TEST(MidMotion, TheTaskFliesAsTheMotionAndGoesOnAsLongBehindIt) {
  const Task& task = flip().ready.task;
  const Task usual = read_task("hopper_flip");
  constexpr double kRow_s = 5e-3;  // rows of the motion are no further apart
  EXPECT_NEAR(task.phase.take_off_s, 0.641, kRow_s);
  EXPECT_NEAR(task.phase.landing_s, 1.134, kRow_s);
  EXPECT_EQ(task.goal.landing_s, task.phase.landing_s);
  EXPECT_NEAR(task.duration_s - task.phase.landing_s, usual.duration_s - usual.phase.landing_s,
              1e-12);
  EXPECT_NEAR(task.phase.end_s - task.phase.landing_s, usual.phase.end_s - usual.phase.landing_s,
              1e-12);
}

TEST(MidMotion, GoesThroughTheWholeMotionAndTurnsOnce) {
  const Flip& of = flip();
  dynamics::TreeState state(of.ready.robot.tree);
  for (std::size_t i = 0; i < of.states.size(); ++i) {
    const MidState& at = of.states[i];
    ASSERT_EQ(at.control, static_cast<long>(i));
    state.set(at.position, at.velocity);
    const double time_s = 0.01 * static_cast<double>(i);
    const bool flies = time_s > of.flight.from_s && time_s < of.flight.until_s;
    EXPECT_EQ(lowest_m(of.ready.robot, state) > 2e-3, flies) << at.control;
  }
  EXPECT_GT(0.01 * static_cast<double>(of.states.size()), of.motion.duration_s() - 0.01);
  // On a level sole pitch, knee and ankle add up to whole turns: none at the begin, one at the end.
  // The base begins its turn from where it leans at the task's start.
  const double lean_rad = of.ready.start_position[2];
  const auto sole_rad = [&](const MidState& at) {
    return lean_rad + at.turned_rad + at.position[3] + at.position[4];
  };
  constexpr double kLevel_rad = 0.02;
  EXPECT_NEAR(sole_rad(of.states.front()), 0.0, kLevel_rad);
  EXPECT_NEAR(sole_rad(of.states.back()), 2.0 * std::numbers::pi, kLevel_rad);
}

// Oracle: the PD law itself, on the motion's own way.
TEST(MidMotion, TheCourseAsksForTheTorquesOfTheMotion) {
  Flip of = flip();
  for (std::size_t i = 0; i < of.states.size(); ++i) {
    of.states[i].joint_Nm = Eigen::Vector3d(0.1 * static_cast<double>(i * i), -30.0, 0.0);
  }
  Skill skill = of.ready.skill;
  set_course(of.states, skill);
  ASSERT_EQ(skill.outputs.size(), 2u);
  for (std::size_t i = 0; i + 1 < of.states.size(); ++i) {
    const MidState &at = of.states[i], &next = of.states[i + 1];
    const Eigen::VectorXd joint_rad = 0.5 * (at.position + next.position).tail(3);
    const Eigen::VectorXd joint_rad_s = 0.5 * (at.velocity + next.velocity).tail(3);
    for (Eigen::Index output = 0; output < 2; ++output) {
      const Eigen::Index joint = skill.acted[static_cast<std::size_t>(output)];
      const PolicyOutput& asked = skill.outputs[static_cast<std::size_t>(output)];
      const double target_rad = asked.offset + asked.course[i];
      const double law_Nm = skill.gains.stiffness_Nm_rad[joint] * (target_rad - joint_rad[joint]) -
                            skill.gains.damping_Nm_s_rad[joint] * joint_rad_s[joint];
      EXPECT_NEAR(law_Nm, 0.5 * (at.joint_Nm + next.joint_Nm)[joint], 1e-9);
    }
  }
}

// Oracle: the motion's rows, whose dynamics are those of the robot. In the air, where the hand-made
// flip stays in the region, the course alone goes as the motion does. A state is that of the row at
// or up to 2 ms behind its instant, at up to 13 rad/s.
TEST(MidMotion, WithoutAnActionAnEpisodeGoesOnAsTheMotion) {
  Flip of = flip();
  Motion asked = of.motion;
  asked.efforts = check_motion(of.robot, asked, {}).demand.joint_effort;
  of.states = mid_states(of.ready, asked);
  ReadyTask ready = of.ready;
  set_course(of.states, ready.skill);
  EpisodeOptions episodes;
  episodes.engine = &engines::own;
  episodes.mid_share = 1.0;
  const auto landing = std::lround(of.ready.task.phase.landing_s / of.ready.task.control_period_s);
  const auto begin = static_cast<std::size_t>(landing - 30);
  episodes.mid_states =
      std::make_shared<const std::vector<MidState>>(std::vector<MidState>{of.states[begin]});
  HopperEnvironment environment(ready, episodes);
  environment.begin(1, 0);
  for (std::size_t i = 1; i <= 15; ++i) {
    environment.act(Eigen::Vector2d::Zero());
    const Eigen::VectorXd off = environment.position() - of.states[begin + i].position;
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 2e-3 * 13.0) << i;
  }
}

TEST(MidMotion, EpisodesBeginThereAsOftenAsSaid) {
  const Flip& of = flip();
  EpisodeOptions episodes;
  episodes.engine = &engines::own;
  episodes.mid_states = std::make_shared<const std::vector<MidState>>(of.states);
  HopperEnvironment environment(of.ready, episodes);
  const learning::Sizes sizes = HopperEnvironment::sizes(of.ready);
  Eigen::VectorXd actor(sizes.actor_inputs), critic(sizes.critic_inputs);
  int whole = 0;
  constexpr int kEpisodes = 200;
  for (int episode = 0; episode < kEpisodes; ++episode) {
    environment.begin(1, static_cast<std::uint64_t>(episode));
    environment.observe(actor, critic);
    // Behind the actor's inputs: velocity, height, turn, time.
    const double turned_rad = critic[sizes.actor_inputs + 4];
    const double time_s = critic[sizes.actor_inputs + 5];
    if (time_s == 0.0) {
      ++whole;
      EXPECT_EQ(turned_rad, 0.0);
      continue;
    }
    const auto control = std::lround(time_s / of.ready.task.control_period_s);
    const auto& state = of.states[static_cast<std::size_t>(control - of.states.front().control)];
    ASSERT_EQ(state.control, control);
    EXPECT_EQ(environment.position(), state.position);
    EXPECT_EQ(turned_rad, state.turned_rad);
  }
  // Half of 200, by five deviations of a binomial.
  EXPECT_NEAR(whole, kEpisodes / 2, 5.0 * std::sqrt(0.25 * kEpisodes));
}

// Oracle: the motion, which is in the air from 0.641 to 1.134 s: who begins in there, however late,
// comes down from one flight, and who begins behind it has flown.
TEST(MidMotion, AFlightCountsWhereverAnEpisodeBegins) {
  const Flip& of = flip();
  ReadyTask ready = of.ready;
  set_course(of.states, ready.skill);
  for (const std::size_t control : {70U, 108U, 120U}) {
    EpisodeOptions episodes;
    episodes.engine = &engine_named("own");
    episodes.mid_states = std::make_shared<const std::vector<MidState>>(1, of.states.at(control));
    episodes.mid_share = 1.0;
    HopperEnvironment environment(ready, episodes);
    environment.begin(1, 0);
    learning::Outcome outcome;
    while (!outcome.ended && !outcome.cut) outcome = environment.act(Eigen::Vector2d::Zero());
    EXPECT_EQ(environment.take_ended().at(0).flights, 1) << control;
  }
}

TEST(MidMotion, RefusesWhatDoesNotFly) {
  try {
    flight_of(flip().ready, flip().read("hopper_squat"));
    FAIL() << "a squat was taken for a flight";
  } catch (const io::SpecError& error) {
    EXPECT_NE(std::string(error.what()).find("hopper_squat.csv"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("never leaves the ground"), std::string::npos);
  }
}

}  // namespace
}  // namespace torquewright::hopper
