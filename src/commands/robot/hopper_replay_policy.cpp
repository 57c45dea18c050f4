// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "hopper/policy/policy_spec.hpp"
#include "hopper/skill/policy_controller.hpp"
#include "hopper/skill/policy_findings.hpp"
#include "hopper/training/task/policy_skill.hpp"
#include "hopper/training/task/task_ends.hpp"
#include "hopper/training/task/task_spec.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/robot/hopper_replay_json.hpp"
#include "src/commands/robot/hopper_replay_parts.hpp"
#include "src/commands/robot/hopper_replay_trials.hpp"
#include "src/interrupt.hpp"
#include "src/options/output_files.hpp"

namespace torquewright::cli {
namespace {

/// Options of following a motion, which a policy does not.
void require_no_tracking(const HopperReplayRequest& request) {
  const HopperReplayRequest usual;
  const auto refuse_if = [](bool is_given, const char* option) {
    if (is_given) io::refuse(option, "is for following a motion: a policy follows none");
  };
  refuse_if(request.controller != usual.controller, "--controller");
  refuse_if(!request.tasks_file.empty(), "--tasks");
  refuse_if(request.impact != usual.impact, "--impact");
  refuse_if(request.fixed_clock, "--fixed-clock");
  refuse_if(request.without_filter, "--no-filter");
  refuse_if(!request.motion.columns.empty() || !request.motion.columns_files.empty(), "--column");
  refuse_if(!request.pushes.empty(), "--push");
  refuse_if(request.motion.hops > 0, "--hops");
}

hopper::Task task_of(const HopperReplayRequest& request, const hopper::PolicyDocument& document) {
  const std::string& file = request.motion.trajectory_file;
  if (!request.task.empty()) return hopper::read_task(request.task);
  if (!document.training_task.empty()) return hopper::task_of(document.training_task, file);
  const auto names = hopper::training_task_names();
  if (std::find(names.begin(), names.end(), document.task) != names.end()) {
    return hopper::read_task(document.task);
  }
  io::refuse(file, "does not say what it is to do: --task names what it is judged by");
}

/// The policy's PD law acts at every look: as in training unless another period is asked for.
HopperReplayRequest with_looks_of(HopperReplayRequest request, const hopper::Task& task) {
  const HopperReplayRequest usual;
  if (request.control_period_s == usual.control_period_s) request.control_period_s = task.step_s;
  return request;
}

hopper::PolicyUse use_of(const HopperReplayRequest& request, const hopper::ReadRobot& read,
                         const hopper::Task& task) {
  hopper::PolicyUse use{task.in_plane, request.limits, {}};
  for (const io::Document& one : read.documents) use.sha256.push_back(one.sha256);
  return use;
}

hopper::ReplayOptions policy_options(const HopperReplayRequest& request,
                                     const HopperCheckInputs& inputs, const hopper::Task& task) {
  hopper::ReplayOptions options = replay_options(request, inputs);
  options.controller = &hopper::policy_kind;
  // What a foot that lands at the end of a task has time for.
  options.verdict.standing.at_rest_s = std::min(0.3, options.verdict.standing.at_rest_s);
  options.filters_noise = task.filters_sensors;  // as it has learned
  return options;
}

}  // namespace

bool names_policy(const std::string& file) {
  return std::filesystem::path(file).extension() == ".json";
}

ExitCode run_policy_replay(const HopperReplayRequest& asked) {
  require_no_tracking(asked);
  check_replay_files(asked);
  require_page("--report", asked.report_file);
  HopperCheckInputs inputs;
  inputs.robot = hopper::read_robot(asked.motion.robot_file);
  inputs.check = check_options(asked.motion, inputs.robot);
  const hopper::PolicyDocument document = hopper::read_policy(asked.motion.trajectory_file).policy;
  const hopper::Task task = task_of(asked, document);
  const HopperReplayRequest request = with_looks_of(asked, task);
  require_consistent(request);
  hopper::ReadyTask ready = hopper::ready_task(inputs.robot.robot, task);
  ready.skill = hopper::skill_of(ready, document, request.motion.trajectory_file);
  hopper::Motion motion = hopper::motion_of_ends(ready);
  motion.file = request.motion.trajectory_file;
  motion.sha256 = document.sha256;
  const auto randomised = read_trials(request, ready.robot);
  catch_interrupt();
  if (randomised) inputs.columns.push_back(randomised->document);
  hopper::Goal goal = task.goal;
  hopper::Command command;
  if (task.forward_m_s) goal.forward_m_s = command.forward_m_s = request.forward_m_s.value_or(0.0);
  const hopper::Replay replay(
      ready.robot,
      {hopper::reference_of_ends(ready), goal,
       hopper::policy_controller(ready.robot, ready.skill, document.policy, command)},
      policy_options(request, inputs, task));
  std::optional<hopper::ReplayTrials> trials;
  if (randomised) {
    trials = run_replay_trials(replay, randomised->randomisation, request,
                               hopper_trials_fingerprint(request, inputs, motion));
    if (!trials) return ExitCode::kPasses;  // a worker's work is done
    if (request.explains) explain_trials(replay, randomised->randomisation, request, *trials);
  }
  hopper::ReplayedRun run = run_once(replay, "replaying");
  hopper::ReplayReport report{replay.options(), std::move(run.result), {}, std::move(trials)};
  if (request.sweep) report.sweep = sweep(replay);
  for (hopper::Finding& one :
       hopper::policy_findings(document, use_of(request, inputs.robot, task))) {
    report.result.findings.push_back(std::move(one));
  }
  write_answer(request, inputs, {ready.robot, motion, replay.reference(), run.record, report},
               record_of_asked_trial(replay, randomised, request));
  return replay_code(report);
}

}  // namespace torquewright::cli
