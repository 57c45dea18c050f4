// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_sweep.hpp"

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "src/commands/planning/hopper_flip_inputs.hpp"
#include "src/commands/planning/hopper_flip_json.hpp"
#include "src/commands/planning/hopper_flip_row.hpp"
#include "src/commands/planning/hopper_flip_trials.hpp"
#include "src/commands/robot/robot_sweep.hpp"
#include "src/interrupt.hpp"
#include "src/options/hopper_flip_request.hpp"

namespace torquewright::cli {
namespace {

std::vector<std::filesystem::path> named_inputs(const HopperFlipRequest& request) {
  std::vector<std::filesystem::path> inputs{request.warm.robot_file};
  for (const std::string* file : {&request.warm.trajectory_file, &request.trials.randomise_file}) {
    if (!file->empty()) inputs.emplace_back(*file);
  }
  return inputs;
}

/// The plan of one robot, and how many of its trials succeed, where any are asked for.
sweep::SweepRow row_at(const HopperFlipInputs& inputs, const std::optional<PlanTrials>& trials,
                       const hopper::Robot& robot) {
  const hopper::CheckOptions& check = inputs.plan.check;
  const hopper::PlanResult result = hopper::plan_motion(robot, inputs.plan);
  sweep::SweepRow row = hopper_flip_row(robot, check, result);
  if (!trials) return row;
  std::optional<hopper::TrialOutcomes> outcomes;
  if (result.status == hopper::PlanStatus::kPlanned) {
    outcomes = outcomes_of(*trials, check, robot, result, TrialThreads::kOne);
  }
  add_trials(outcomes, row);
  return row;
}

}  // namespace

ExitCode run_hopper_flip_sweep(const HopperFlipRequest& request) {
  refuse_of_one_robot(*request.declared);
  const std::string& output_file = request.motion_file;
  require_sweep_outputs(request.sweep, output_file, named_inputs(request));
  HopperFlipInputs inputs = read_flip_inputs(request);
  const std::optional<PlanTrials> trials = read_plan_trials(request, inputs);
  if (trials) inputs.columns.push_back(trials->read.document);
  // Now that the robot's files are known.
  require_sweep_outputs(request.sweep, output_file, named_inputs(request));
  const hopper::Robot& robot = inputs.robot.robot;
  const RobotSweep asked = read_robot_sweep(request.sweep, robot, inputs.plan.check.conditions);
  catch_interrupt();
  const auto swept = run_robot_sweep(
      asked, robot, {"hopper flip", hopper_flip_fingerprint(request, inputs)}, request.sweep.points,
      output_file, [&](const hopper::Robot& varied) { return row_at(inputs, trials, varied); });
  if (!swept) return ExitCode::kPasses;
  write_swept(*swept, request.sweep, output_file, request.json,
              hopper_flip_sweep_json(request, inputs, *swept));
  return code_of(*swept);
}

}  // namespace torquewright::cli
