// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "hopper/check/series.hpp"
#include "hopper/engines/library.hpp"
#include "hopper/record/run_series.hpp"
#include "hopper/tracking/library.hpp"
#include "hopper/tracking/operational/tasks_spec.hpp"
#include "hopper/trials/causes.hpp"
#include "hopper/trials/randomisation_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"
#include "src/commands/robot/hopper_commands.hpp"
#include "src/commands/robot/hopper_replay_json.hpp"
#include "src/commands/robot/hopper_replay_parts.hpp"
#include "src/commands/robot/hopper_replay_trials.hpp"
#include "src/interrupt.hpp"
#include "src/options/output_files.hpp"
#include "src/options/push_options.hpp"
#include "src/report/motion/replay_html.hpp"
#include "src/report/motion/replay_text.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/standard_output.hpp"
#include "src/sweep/journal_json.hpp"
#include "src/sweep/sweep.hpp"

namespace torquewright::cli {
namespace {}  // namespace

void check_replay_files(const HopperReplayRequest& request) {
  const std::string journal = asks_for_processes(request.points)
                                  ? journal_of(request.points, request.output_file)
                                  : std::string();
  check_written(named({request.report_file, request.series_file, request.output_file, journal}),
                {request.motion.robot_file, request.motion.trajectory_file});
  if (!sweep::is_silent()) sweep::check_journal(journal);  // else who started this process has it
}

namespace {

hopper::ImpactOptions impact_of(const HopperReplayRequest& request) {
  hopper::ImpactOptions impact;
  impact.handling = request.impact == "invariant"       ? hopper::ImpactHandling::kInvariant
                    : request.impact == "no_derivative" ? hopper::ImpactHandling::kNoDerivative
                                                        : hopper::ImpactHandling::kDefault;
  impact.metric = request.impact_metric == "inertia" ? hopper::ImpactMetric::kInertia
                                                     : hopper::ImpactMetric::kEuclidean;
  impact.whole_foot = request.impact_contact == "foot";
  impact.window_s = request.impact_window_s;
  impact.blend_s = request.impact_blend_s;
  return impact;
}

void require_step(const HopperReplayRequest& request) {
  if (request.step_s <= request.control_period_s) return;
  io::refuse("--step",
             fmt::format("{:g} s is longer than the control period of {:g} s: a step lies "
                         "between two looks; lengthen --control-period, or shorten it",
                         request.step_s, request.control_period_s));
}

/// A control period is a whole number of the engine's steps, which are made to fit.
hopper::RunOptions run_of(const HopperReplayRequest& request) {
  hopper::RunOptions run;
  run.steps_per_control =
      std::max(1, static_cast<int>(std::ceil(request.control_period_s / request.step_s - 1e-9)));
  run.step_s = request.control_period_s / run.steps_per_control;
  run.latency_steps = static_cast<int>(std::lround(request.latency_s / run.step_s));
  run.stand_s = request.stand_s;
  run.ground_height_m = request.motion.check.contact.ground_height_m + request.ground_rise_m;
  return run;
}

/// An impact's window must be seen by the controller.
void require_window(const HopperReplayRequest& request) {
  if (request.impact == "default" || request.control_period_s <= request.impact_window_s) return;
  io::refuse("--impact-window",
             fmt::format("{:g} s is shorter than the control period of {:g} s: no look would fall "
                         "into it; widen it, or shorten --control-period",
                         request.impact_window_s, request.control_period_s));
}

/// Of no time at all nothing could be said.
void require_time(const HopperReplayRequest& request, const hopper::Motion& motion) {
  const double lasts_s = motion.times_s.back() - motion.times_s.front() + request.stand_s;
  if (lasts_s >= request.control_period_s) return;
  io::refuse("--stand", fmt::format("the motion and {:g} s of standing last {:g} s, less than one "
                                    "--control-period of {:g} s: nothing would be replayed",
                                    request.stand_s, lasts_s, request.control_period_s));
}

/// What a run as it is asked for would drop.
void require_effect(const HopperReplayRequest& request) {
  const HopperReplayRequest usual;
  const bool is_handled = request.impact != "default";
  const bool is_split = request.impact == "invariant";
  const auto refuse_unless = [](bool has_effect, bool is_usual, const char* option,
                                const char* why) {
    if (!has_effect && !is_usual) io::refuse(option, why);
  };
  const char* const split = "belongs with --impact invariant, which alone splits the error";
  const char* const handled =
      "belongs with --impact no_derivative or invariant: by default impacts have no window";
  refuse_unless(is_split, request.impact_metric == usual.impact_metric, "--impact-metric", split);
  refuse_unless(is_split, request.impact_contact == usual.impact_contact, "--impact-contact",
                split);
  refuse_unless(is_handled, request.impact_window_s == usual.impact_window_s, "--impact-window",
                handled);
  refuse_unless(is_handled, request.impact_blend_s == usual.impact_blend_s, "--impact-blend",
                handled);
}

/// What an engine cannot hold of a robot it says when it is made.
void require_held(const hopper::EngineKind& engine, const hopper::Robot& robot) {
  try {
    (void)engine.make(robot, {});
  } catch (const std::invalid_argument& error) {
    io::refuse("--engine", error.what());
  }
}

}  // namespace

void require_consistent(const HopperReplayRequest& request) {
  if (!request.tasks_file.empty() && !hopper::controller_named(request.controller).has_tasks) {
    io::refuse("--tasks", "belongs with --controller osc, which alone weighs tasks");
  }
  require_step(request);
  require_window(request);
  require_effect(request);
}

hopper::ReplayOptions replay_options(const HopperReplayRequest& request,
                                     const HopperCheckInputs& inputs) {
  hopper::ReplayOptions options;
  options.engine = &hopper::engine_named(request.engine);
  require_held(*options.engine, inputs.robot.robot);
  options.controller = &hopper::controller_named(request.controller);
  options.limits = request.limits == "box" ? hopper::DriveLimits::kBox : hopper::DriveLimits::kMor;
  options.impact = impact_of(request);
  options.clock.resynchronise = !request.fixed_clock;
  options.run = run_of(request);
  options.engine_options.ground_height_m = options.run.ground_height_m;
  options.engine_options.contact_time_constant_s = request.contact_time_constant_s;
  options.verdict.standing.at_rest_s =
      std::min(options.verdict.standing.at_rest_s, 0.5 * request.stand_s);
  options.verdict.deeds = request.deeds;
  if (options.controller->has_speed) options.forward_m_s = request.forward_m_s;
  options.load_window_s = request.motion.check.load_window_s;
  options.filters_noise = !request.without_filter;
  options.conditions = inputs.check.conditions;
  return options;
}

hopper::ReplayedRun run_once(const hopper::Replay& replay, const char* what) {
  report::ProgressLine progress;
  return replay.run({is_interrupted, [&](double share) {
                       progress.show(fmt::format("{}: {:.0f} %", what, 100.0 * share));
                     }});
}

std::vector<hopper::SweptStep> sweep(const hopper::Replay& replay) {
  report::ProgressLine progress;
  return replay.sweep({is_interrupted, [&](double share) {
                         progress.show(fmt::format("another step: {:.0f} %", 100.0 * share));
                       }});
}

std::optional<hopper::ReadRandomisation> read_trials(const HopperReplayRequest& request,
                                                     const hopper::Robot& robot) {
  if (request.trials == 0) return std::nullopt;
  if (request.randomise_file.empty()) {
    io::refuse("--trials",
               "needs --randomise FILE, a document of kind randomisation: what differs from trial "
               "to trial");
  }
  if (request.explains && asks_for_processes(request.points)) {
    io::refuse("--explain", "runs its trials by threads: leave out --jobs and --sweep-journal");
  }
  if (request.explains && request.only_trial >= 0) {
    io::refuse("--explain", "is of many trials, and --trial runs one alone");
  }
  if (request.only_trial >= static_cast<std::int64_t>(request.trials)) {
    io::refuse("--trial", fmt::format("{} is not one of the trials 0 to {}", request.only_trial,
                                      request.trials - 1));
  }
  hopper::ReadRandomisation read = hopper::read_randomisation(request.randomise_file);
  if (hopper::causes_of(read.randomisation).empty()) {
    io::refuse(
        request.randomise_file,
        "varies nothing: every trial would be the same run, and their rate would say nothing; "
        "give a range whose least is below its greatest, or sensor_noise");
  }
  if (request.without_filter && !hopper::has_noise(read.randomisation.noise)) {
    io::refuse("--no-filter", fmt::format("{} states no sensor_noise: there is nothing to filter",
                                          request.randomise_file));
  }
  hopper::require_fits(read.randomisation, robot);
  return read;
}

namespace {

ExitCode code_of(hopper::RateVerdict verdict) {
  switch (verdict) {
    case hopper::RateVerdict::kReached:
      return ExitCode::kPasses;
    case hopper::RateVerdict::kMissed:
      return ExitCode::kFails;
    default:
      return ExitCode::kUndecided;
  }
}

ExitCode code_of(hopper::ReplayVerdict verdict) {
  switch (verdict) {
    case hopper::ReplayVerdict::kStands:
      return ExitCode::kPasses;
    case hopper::ReplayVerdict::kMissed:
    case hopper::ReplayVerdict::kTrembles:
    case hopper::ReplayVerdict::kFell:
      return ExitCode::kFails;
    default:
      return ExitCode::kUndecided;
  }
}

}  // namespace

ExitCode replay_code(const hopper::ReplayReport& report) {
  if (!report.trials) return code_of(report.result.outcome.verdict);
  return code_of(hopper::judged_rate(report.trials->counts(), report.trials->required_share));
}

void write_answer(const HopperReplayRequest& request, const HopperCheckInputs& inputs,
                  const report::ReplayPage& page, const std::optional<hopper::Record>& of_trial) {
  const auto& [robot, motion, reference, record, report] = page;
  std::vector<io::FileContent> files;
  if (!request.series_file.empty()) {
    files.push_back({request.series_file,
                     hopper::series_csv(hopper::run_series(robot, of_trial ? *of_trial : record))});
  }
  if (!request.report_file.empty()) {
    files.push_back({request.report_file, report::replay_html(page)});
  }
  deliver_report(
      {hopper_replay_json(request, inputs, motion, report),
       report::replay_text(robot, motion, report, least_severity(request.motion.severity))},
      request.output_file, request.json, std::move(files));
}

namespace {

/// What only a policy has.
void require_no_task(const HopperReplayRequest& request) {
  if (!request.task.empty()) io::refuse("--task", "is for policies: a motion is its own task");
  if (request.forward_m_s && !hopper::controller_named(request.controller).has_speed) {
    io::refuse("--forward",
               "commands a policy or --controller stepping; else a motion goes as it is planned");
  }
}

/// What a controller of tasks weighs, where a document says so.
void add_tasks(const HopperReplayRequest& request, const hopper::Robot& robot,
               hopper::ReplayOptions& options, HopperCheckInputs& inputs) {
  if (request.tasks_file.empty()) return;
  hopper::ReadTasks read = hopper::read_tasks(request.tasks_file, robot);
  options.tasks = std::make_shared<const hopper::OperationalTasks>(std::move(read.tasks));
  inputs.columns.push_back(std::move(read.document));
}

ExitCode run_hopper_replay(const HopperReplayRequest& request) {
  if (names_policy(request.motion.trajectory_file)) return run_policy_replay(request);
  require_no_task(request);
  check_replay_files(request);
  require_consistent(request);
  auto [inputs, motion] = read_inputs(request.motion);
  require_time(request, motion);
  const hopper::Robot& robot = inputs.robot.robot;
  hopper::RunOptions finest = run_of(request);
  if (request.sweep) finest.step_s /= 4.0;  // as Replay::sweep() does
  hopper::require_few_steps(motion, finest);
  const auto pushes = read_pushes(request.pushes, robot, motion, request.stand_s);
  const auto randomised = read_trials(request, robot);
  check_replay_files(request);  // now that the files that others name are known
  require_page("--report", request.report_file);
  hopper::ReplayOptions options = replay_options(request, inputs);
  add_tasks(request, robot, options, inputs);
  const hopper::HopperReport check = hopper::check_motion(robot, motion, inputs.check);
  catch_interrupt();
  if (randomised) inputs.columns.push_back(randomised->document);
  options.run.pushes = pushes;
  options.acts_late = randomised && randomised->randomisation.latency_s;
  const hopper::Replay replay(robot, motion, check, options);
  std::optional<hopper::ReplayTrials> trials;
  if (randomised) {
    trials = run_replay_trials(replay, randomised->randomisation, request,
                               hopper_trials_fingerprint(request, inputs, motion));
    if (!trials) return ExitCode::kPasses;  // a worker's work is done
    if (request.explains) explain_trials(replay, randomised->randomisation, request, *trials);
  }
  hopper::ReplayedRun run = run_once(replay, "replaying");
  hopper::ReplayReport report{replay.options(), std::move(run.result), {}, {}};
  if (request.sweep) report.sweep = sweep(replay);
  report.trials = std::move(trials);
  hopper::add_planned_findings(check, report.result.findings);
  write_answer(request, inputs, {robot, motion, replay.reference(), run.record, report},
               record_of_asked_trial(replay, randomised, request));
  return replay_code(report);
}

}  // namespace

void add_replay_command(command_line::Command& group) {
  auto request = std::make_shared<HopperReplayRequest>();
  command_line::Command command =
      group.add_command("replay", "Does the robot do the motion, simulated and controlled?");
  add_hopper_replay_options(command, *request);
  command.example(fmt::format(
      "torquewright {} replay specs/robot/hopper.json specs/trajectory/hopper_squat.csv",
      group.declared().name));
  command.works([request] { return run_hopper_replay(*request); });
}

}  // namespace torquewright::cli
