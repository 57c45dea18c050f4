// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_replay_trials.hpp"

#include <fmt/format.h>

#include "hopper/replay_report/replay_report_spec.hpp"
#include "hopper/trials/causes.hpp"
#include "src/interrupt.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/sweep/sweep.hpp"

namespace torquewright::cli {
namespace {

hopper::TrialOutcome trial(const hopper::Replay& replay, const hopper::Randomisation& randomisation,
                           std::uint64_t seed, std::size_t number) {
  const hopper::ReplayedRun done =
      replay.run_trial(randomisation, seed, number, {is_interrupted, {}});
  return hopper::trial_outcome(done.result);
}

std::vector<std::optional<hopper::TrialOutcome>> by_threads(
    const std::string& what, std::size_t count, std::size_t threads,
    const std::function<hopper::TrialOutcome(std::size_t)>& run_one) {
  report::ProgressLine progress;
  hopper::TrialRun run;
  run.count = count;
  run.threads = threads;
  run.should_stop = is_interrupted;
  run.progress = [&](std::size_t done) {
    progress.show(fmt::format("{}: {} of {}", what, done, count));
  };
  return hopper::run_trials(run, run_one);
}

/// A trial whose process ended is one that was not finished.
std::optional<hopper::TrialOutcome> outcome_of(const std::optional<sweep::Answer>& answer) {
  if (!answer) return std::nullopt;
  if (!answer->is_lost) return hopper::trial_of(answer->row);
  hopper::TrialOutcome lost;
  lost.reason = "lost: " + answer->why;
  return lost;
}

}  // namespace

std::optional<hopper::ReplayTrials> run_replay_trials(const hopper::Replay& replay,
                                                      const hopper::Randomisation& randomisation,
                                                      const HopperReplayRequest& request,
                                                      const std::string& fingerprint) {
  hopper::ReplayTrials trials{request.seed, request.success_rate, 0, {}, {}};
  std::size_t count = request.trials;
  if (request.only_trial >= 0) {
    trials.first = static_cast<std::size_t>(request.only_trial);
    count = 1;
  }
  const auto run_one = [&](std::size_t number) {
    return trial(replay, randomisation, request.seed, trials.first + number);
  };
  if (!asks_for_processes(request.points)) {
    trials.outcomes = by_threads("trials", count, request.threads, run_one);
    return trials;
  }
  sweep::Request points;
  for (std::size_t i = 0; i < count; ++i) {
    points.points.push_back(fmt::format("trial={}", trials.first + i));
  }
  points.fingerprint = fingerprint;
  points.journal_file = journal_of(request.points, request.output_file);
  points.jobs = request.points.jobs;
  report::ProgressLine progress;
  const auto outcome = sweep::run_sweep(
      points, [&](std::size_t number) { return hopper::trial_text(run_one(number)); },
      {is_interrupted, [&](std::size_t done, std::size_t all) {
         progress.show(fmt::format("trials: {} of {}", done, all));
       }});
  if (!outcome) return std::nullopt;
  for (const auto& answer : outcome->answers) trials.outcomes.push_back(outcome_of(answer));
  return trials;
}

void explain_trials(const hopper::Replay& replay, const hopper::Randomisation& randomisation,
                    const HopperReplayRequest& request, hopper::ReplayTrials& trials) {
  for (const hopper::Cause& cause : hopper::causes_of(randomisation)) {
    const auto alone = by_threads(
        cause.name, request.trials, request.threads,
        [&](std::size_t number) { return trial(replay, cause.alone, request.seed, number); });
    trials.causes.push_back(hopper::effect_of_cause(cause.name, alone, trials.outcomes));
  }
}

std::optional<hopper::Record> record_of_asked_trial(
    const hopper::Replay& replay, const std::optional<hopper::ReadRandomisation>& randomised,
    const HopperReplayRequest& request) {
  if (!randomised || request.only_trial < 0 || request.series_file.empty()) return std::nullopt;
  hopper::ReplayedRun run =
      replay.run_trial(randomised->randomisation, request.seed,
                       static_cast<std::size_t>(request.only_trial), {is_interrupted, {}});
  return std::move(run.record);
}

}  // namespace torquewright::cli
