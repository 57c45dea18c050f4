// SPDX-License-Identifier: Apache-2.0
// Oracle: `hopper replay`'s own run of the same policy (run.cpp), which has a loop of its own: both
// must come to the same positions to the last bit, with and without noise, latency, another robot
// and another voltage.
#include <gtest/gtest.h>

#include "hopper/engines/library.hpp"
#include "hopper/skill/policy_controller.hpp"
#include "hopper/training/episode/hopper_environment.hpp"
#include "hopper/training/run/training.hpp"
#include "hopper/training/task/task_ends.hpp"
#include "hopper/training/task/task_spec.hpp"
#include "hopper/trials/counted_random.hpp"
#include "hopper/trials/randomisation_spec.hpp"
#include "hopper/trials/trial.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

const ReadRobot& hopper_file() {
  static const ReadRobot read = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json");
  return read;
}

const ReadyTask& ready_for(const char* task) {
  static std::map<std::string, ReadyTask> ready;
  const auto found = ready.find(task);
  if (found != ready.end()) return found->second;
  return ready.emplace(task, ready_task(hopper_file().robot, read_task(task))).first->second;
}

/// A layer of small numbers that no symmetry makes zero.
learning::Policy some_policy(const ReadyTask& ready) {
  const auto inputs = static_cast<Eigen::Index>(ready.skill.inputs.size());
  const auto outputs = static_cast<Eigen::Index>(ready.skill.outputs.size());
  learning::Policy policy;
  policy.normalisation.mean = Eigen::VectorXd::Zero(inputs);
  policy.normalisation.deviation = Eigen::VectorXd::Ones(inputs);
  learning::Layer layer;
  layer.activation = learning::activation_of(learning::ActivationKind::kIdentity);
  layer.weights.resize(outputs, inputs);
  for (Eigen::Index i = 0; i < layer.weights.size(); ++i) {
    layer.weights(i) = 0.1 * normal_of(mixed_in(7, static_cast<std::uint64_t>(i)));
  }
  layer.bias = Eigen::VectorXd::Constant(outputs, 0.05);
  policy.layers = {layer};
  return policy;
}

void expect_equal_runs(const ReadyTask& ready, const EpisodeOptions& episodes, std::size_t trial) {
  constexpr std::uint64_t kSeed = 5;
  const learning::Policy policy = some_policy(ready);
  const Replay replay(ready.robot,
                      {reference_of_ends(ready), ready.task.goal,
                       policy_controller(ready.robot, ready.skill, policy, {})},
                      replay_options_of(ready, episodes));
  const Record record = replay.run_trial(episodes.randomisation, kSeed, trial, {}).record;

  HopperEnvironment environment(ready, episodes);
  const learning::Sizes sizes = HopperEnvironment::sizes(ready);
  Eigen::VectorXd actor(sizes.actor_inputs), critic(sizes.critic_inputs);
  learning::PolicyEvaluation evaluation(policy);
  environment.begin(kSeed, trial);
  const auto looks =
      static_cast<std::size_t>(std::lround(ready.task.control_period_s / ready.task.step_s));
  std::size_t compared = 0;
  for (std::size_t control = 0;; ++control) {
    const std::size_t row = control * looks;
    if (row < record.rows.size()) {
      ASSERT_EQ(record.rows[row].position, environment.position()) << "control step " << control;
      ASSERT_EQ(record.rows[row].velocity, environment.velocity()) << "control step " << control;
      ++compared;
    }
    environment.observe(actor, critic);
    const learning::Outcome outcome = environment.act(evaluation.action(actor));
    if (outcome.ended || outcome.cut) break;
  }
  EXPECT_GT(compared, 15u);
}

EpisodeOptions plain_episodes(const char* engine = "own") {
  EpisodeOptions episodes;
  episodes.engine = &engine_named(engine);
  return episodes;
}

TEST(HopperEnvironment, MovesAsAReplayOfTheSamePolicyDoes) {
  expect_equal_runs(ready_for("hopper_flip"), plain_episodes(), 0);
  expect_equal_runs(ready_for("stand"), plain_episodes(), 0);
}

TEST(HopperEnvironment, MovesAsAReplayDoesInTheBoxAndInMujoco) {
  EpisodeOptions episodes = plain_episodes();
  episodes.limits = DriveLimits::kBox;
  expect_equal_runs(ready_for("hopper_flip"), episodes, 0);
  if (mujoco_absence()) GTEST_SKIP() << *mujoco_absence();
  expect_equal_runs(ready_for("hopper_flip"), plain_episodes("mujoco"), 0);
}

TEST(HopperEnvironment, MovesAsAReplayDoesAlongACourse) {
  ReadyTask ready = ready_for("hopper_flip");
  const ReadyTask without = ready;
  ready.skill.outputs[0].course = {0.1, -0.4, 0.3, 0.9, -0.2, 0.2};
  ready.skill.outputs[1].course = {-0.1, 0.2};
  expect_equal_runs(ready, plain_episodes(), 0);
  const EpisodeOptions episodes = plain_episodes();
  HopperEnvironment along(ready, episodes), plain(without, episodes);
  along.begin(1, 0);
  plain.begin(1, 0);
  along.act(Eigen::Vector2d::Zero());
  plain.act(Eigen::Vector2d::Zero());
  EXPECT_NE(along.position(), plain.position());
}

TEST(HopperEnvironment, DrawsTheSameTrialsAsAReplay) {
  EpisodeOptions episodes = plain_episodes();
  episodes.randomisation =
      read_randomisation(TORQUEWRIGHT_SOURCE_DIR "/specs/randomisation/hopper.json").randomisation;
  episodes.randomisation.latency_s = Range{0.0, 0.01};
  // The voltage is asked for in another way there, so that it is equal to rounding alone.
  episodes.randomisation.bus_voltage_factor.reset();
  expect_equal_runs(ready_for("hopper_flip"), episodes, 1);
  expect_equal_runs(ready_for("hopper_flip"), episodes, 2);
  ReadyTask filtered = ready_for("hopper_flip");
  filtered.task.filters_sensors = true;
  expect_equal_runs(filtered, episodes, 1);
}

// Oracle: the draw of the trial itself, and the engine's own state; a policy sees neither.
TEST(HopperEnvironment, ShowsTheCriticWhatTheTrialDrewAndNoNoise) {
  const ReadyTask& ready = ready_for("hopper_flip");
  EpisodeOptions episodes = plain_episodes();
  episodes.randomisation =
      read_randomisation(TORQUEWRIGHT_SOURCE_DIR "/specs/randomisation/hopper.json").randomisation;
  HopperEnvironment environment(ready, episodes);
  environment.begin(3, 9);
  const learning::Sizes sizes = HopperEnvironment::sizes(ready);
  Eigen::VectorXd actor(sizes.actor_inputs), critic(sizes.critic_inputs);
  environment.act(Eigen::Vector2d::Zero());
  environment.observe(actor, critic);
  const Trial trial = draw_trial(episodes.randomisation, ready.robot, 3, 9);
  EXPECT_EQ(critic.tail(3), trial.further_friction_Nm);
  const Eigen::Index bodies = trial.center_of_mass_shift_m.cols();
  EXPECT_EQ(critic.tail(9 + 3 * bodies).head(3 * bodies), trial.center_of_mass_shift_m.reshaped());
  EXPECT_GT(trial.center_of_mass_shift_m.cwiseAbs().maxCoeff(), 1e-3);
  const Eigen::VectorXd privileged = critic.tail(sizes.critic_inputs - sizes.actor_inputs);
  const auto joints = static_cast<Eigen::Index>(ready.robot.tree.bodies.size()) - 1;
  EXPECT_EQ(privileged.segment(9, joints), environment.position().tail(joints));
  EXPECT_EQ(privileged.segment(9 + joints, joints), environment.velocity().tail(joints));
}

TEST(HopperEnvironment, BeginsAnEpisodeAlikeWhateverWasBefore) {
  const ReadyTask& ready = ready_for("hopper_flip");
  EpisodeOptions episodes = plain_episodes();
  episodes.randomisation =
      read_randomisation(TORQUEWRIGHT_SOURCE_DIR "/specs/randomisation/hopper.json").randomisation;
  HopperEnvironment fresh(ready, episodes), used(ready, episodes);
  const Eigen::VectorXd action = Eigen::VectorXd::Constant(2, 0.3);
  used.begin(1, 11);
  for (int i = 0; i < 8; ++i) used.act(action);
  used.begin(1, 4);
  fresh.begin(1, 4);
  for (int i = 0; i < 30; ++i) {
    const learning::Outcome one = fresh.act(action);
    const learning::Outcome other = used.act(action);
    ASSERT_EQ(one.rewards, other.rewards);
    ASSERT_EQ(fresh.position(), used.position());
    ASSERT_EQ(one.ended, other.ended);
    if (one.ended) break;
  }
}

// Oracle: the PD law by hand. A joint at the end of its range gets torque against its stop only by
// a target beyond it; who holds targets within ranges takes the last half of a push-off from a leg.
TEST(ActingSkill, AsksForTargetsBeyondTheRangesOfJoints) {
  const ReadyTask& ready = ready_for("hopper_flip");
  ActingSkill acting(ready.robot, ready.skill);
  acting.start({});
  Observation seen;
  seen.position = ready.start_position;
  seen.velocity = Eigen::VectorXd::Zero(ready.robot.tree.velocity_size());
  seen.position.tail(3)[0] = 0.2;  // the knee's range begins at 0
  seen.velocity.tail(3)[0] = -8.0;
  acting.see(0.0, seen);
  acting.act(Eigen::Vector2d(-3.0, 0.0));
  Eigen::VectorXd drive_Nm;
  acting.torque(seen, drive_Nm);
  // 150 Nm/rad to 1.1 - 3 rad, 5 Nm s/rad; the four-bar in front of the knee is one to one.
  EXPECT_NEAR(drive_Nm[0], 150.0 * (1.1 - 3.0 - 0.2) + 5.0 * 8.0, 1e-9);
}

TEST(HopperEnvironment, SaysHowAnEpisodeEnded) {
  HopperEnvironment environment(ready_for("hopper_flip"), plain_episodes());
  environment.begin(1, 3);
  learning::Outcome outcome;
  while (!outcome.ended && !outcome.cut) outcome = environment.act(Eigen::Vector2d::Zero());
  const std::vector<EpisodeEnd> ends = environment.take_ended();
  ASSERT_EQ(ends.size(), 1u);
  EXPECT_EQ(ends[0].episode, 3u);
  EXPECT_TRUE(ends[0].fell);
  EXPECT_FALSE(ends[0].did);
  EXPECT_NE(ends[0].reason.find("on the ground"), std::string::npos) << ends[0].reason;
  EXPECT_LT(ends[0].turned_rad, -1.0);  // it leans back and falls there
  EXPECT_TRUE(environment.take_ended().empty());
}

std::string refusal_of(const char* text) {
  try {
    ready_task(hopper_file().robot, task_of(text, "mine.json"));
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "";
}

TEST(TrainingTask, RefusesWhatTheRobotHasNot) {
  const auto task = [](const std::string& more) {
    return R"({"kind": "training_task", "version": 1, "duration_s": 1, )" + more + "}";
  };
  const std::string alive = R"("rewards": [{"term": "alive"}])";
  EXPECT_EQ(refusal_of(task(alive).c_str()), "");
  EXPECT_NE(refusal_of(task(R"("rewards": [{"term": "alve"}])").c_str()).find("\"alive\""),
            std::string::npos);
  EXPECT_NE(refusal_of(task(alive + R"(, "joints": {"hip": {}})").c_str()).find("hip"),
            std::string::npos);
  EXPECT_NE(refusal_of(task(alive + R"(, "start": {"posture": "lie"})").c_str()).find("lie"),
            std::string::npos);
  EXPECT_NE(refusal_of(task(alive + R"(, "phase": {"take_off_s": 1, "landing_s": 0.5})").c_str())
                .find("landing_s"),
            std::string::npos);
}

TEST(TrainingTask, BeginsOnALevelSole) {
  const ReadyTask& ready = ready_for("stand");
  dynamics::TreeState state(ready.robot.tree);
  state.set(ready.start_position, Eigen::VectorXd::Zero(ready.robot.tree.velocity_size()));
  for (const ContactPoint& contact : ready.robot.contacts) {
    EXPECT_NEAR(dynamics::point_position_m(state, contact.point).z(), 0.0, 1e-12) << contact.name;
  }
}

}  // namespace
}  // namespace torquewright::hopper
