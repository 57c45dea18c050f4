// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_trials.hpp"

#include <utility>

#include "hopper/check/hopper_check.hpp"
#include "hopper/trials/run_trials.hpp"
#include "src/interrupt.hpp"

namespace torquewright::cli {
namespace {

HopperReplayRequest replay_request(const HopperFlipRequest& request) {
  HopperReplayRequest replay;
  replay.motion.check.load_window_s = request.warm.check.load_window_s;
  replay.trials = request.trials.count;
  replay.randomise_file = request.trials.randomise_file;
  replay.seed = request.trials.seed;
  replay.controller = request.trials.controller;
  replay.engine = request.trials.engine;
  return replay;
}

hopper::ReplayOptions options_of(const PlanTrials& trials, const hopper::CheckOptions& check,
                                 const hopper::Robot& robot) {
  HopperCheckInputs inputs;
  inputs.robot.robot = robot;
  inputs.check = check;
  hopper::ReplayOptions options = replay_options(trials.replay, inputs);
  options.acts_late = trials.read.randomisation.latency_s.has_value();
  return options;
}

}  // namespace

std::optional<PlanTrials> read_plan_trials(const HopperFlipRequest& request,
                                           const HopperFlipInputs& inputs) {
  HopperReplayRequest replay = replay_request(request);
  std::optional<hopper::ReadRandomisation> read = read_trials(replay, inputs.robot.robot);
  if (!read) return std::nullopt;
  PlanTrials trials{std::move(replay), std::move(*read)};
  options_of(trials, inputs.plan.check, inputs.robot.robot);  // refuses what the engine lacks
  return trials;
}

hopper::TrialOutcomes outcomes_of(const PlanTrials& trials, const hopper::CheckOptions& check,
                                  const hopper::Robot& robot, const hopper::PlanResult& plan,
                                  TrialThreads threads) {
  hopper::Motion motion = plan.motion;
  const hopper::HopperReport report = hopper::check_motion(robot, motion, check);
  const hopper::Replay replay(robot, motion, report, options_of(trials, check, robot));
  hopper::TrialRun run;
  run.count = trials.replay.trials;
  run.threads = threads == TrialThreads::kOne ? 1 : 0;
  run.should_stop = is_interrupted;
  return hopper::run_trials(run, [&](std::size_t number) {
    return hopper::trial_outcome(
        replay.run_trial(trials.read.randomisation, trials.replay.seed, number, {}).result);
  });
}

}  // namespace torquewright::cli
