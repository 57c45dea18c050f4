// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "io/faults/refusal.hpp"
#include "src/commands/planning/hopper_flip_inputs.hpp"
#include "src/commands/planning/hopper_flip_outputs.hpp"
#include "src/commands/planning/hopper_flip_robust.hpp"
#include "src/commands/planning/hopper_flip_sweep.hpp"
#include "src/commands/robot/hopper_commands.hpp"
#include "src/interrupt.hpp"
#include "src/options/hopper_flip_options.hpp"
#include "src/options/output_files.hpp"
#include "src/report/parts/progress_line.hpp"

namespace torquewright::cli {
namespace {

hopper::PlanResult plan(const HopperFlipInputs& inputs) {
  report::ProgressLine progress;
  hopper::PlanOptions options = inputs.plan;
  options.should_stop = is_interrupted;
  options.on_progress = [&progress](const hopper::PlanProgress& at) {
    progress.show(fmt::format(
        "round {}: {} intervals, iteration {}, objective {:.5g}, constraints off by {:.1e}",
        at.round + 1, at.intervals, at.iteration, at.objective, at.largest_violation));
  };
  return hopper::plan_motion(inputs.robot.robot, options);
}

ExitCode code_of(hopper::PlanStatus status) {
  switch (status) {
    case hopper::PlanStatus::kPlanned:
      return ExitCode::kPasses;
    case hopper::PlanStatus::kLocallyInfeasible:
      return ExitCode::kFails;
    default:
      return ExitCode::kUndecided;
  }
}

/// What a single plan needs, and what it would drop.
void require_single(const HopperFlipRequest& request) {
  if (request.motion_file.empty()) {
    io::refuse("--output", "is required: the CSV that the plan is written to");
  }
  if (request.trials.count > 0 && request.robust_file.empty()) {
    io::refuse("--trials",
               "is for --robust and --sweep: `hopper replay` tries a plan that is there");
  }
  if (request.sweep.points.jobs > 0) io::refuse("--jobs", "is for --sweep");
  if (!request.sweep.points.journal_file.empty()) io::refuse("--sweep-journal", "is for --sweep");
}

/// --robust stands for trials of its document.
HopperFlipRequest with_trials(HopperFlipRequest request) {
  if (request.robust_file.empty()) return request;
  if (!request.sweep.axes.empty()) {
    io::refuse("--robust", "is of one robot: --sweep takes --reserve and --trials");
  }
  if (request.plan.explain) {
    io::refuse("--explain", "is of one plan, and --robust makes several: leave out one of them");
  }
  if (!request.trials.randomise_file.empty()) {
    io::refuse("--randomise", "and --robust both name what trials draw: leave out --randomise");
  }
  request.trials.randomise_file = request.robust_file;
  return request;
}

ExitCode run_hopper_flip(const HopperFlipRequest& stated) {
  const HopperFlipRequest request = with_trials(stated);
  if (!request.sweep.axes.empty()) return run_hopper_flip_sweep(request);
  require_single(request);
  require_flip_outputs(request);
  HopperFlipInputs inputs = read_flip_inputs(request);
  check_flip_files(request);  // now that the robot's files are known
  require_page("--report", request.report_file);
  catch_interrupt();
  std::optional<RobustChoice> robust;
  hopper::PlanResult result;
  if (request.robust_file.empty()) {
    result = plan(inputs);
  } else {
    robust = plan_robustly(request, inputs, result);
  }
  write_flip_outputs(request, inputs, result, robust);
  // A choice that was cut short is none of what was asked for.
  return robust && is_interrupted() ? ExitCode::kUndecided : code_of(result.status);
}

}  // namespace

void add_flip_command(command_line::Command& hopper) {
  auto request = std::make_shared<HopperFlipRequest>();
  command_line::Command command =
      hopper.add_command("flip", "Plan a flip, a jump or a hop that these actuators can do");
  add_hopper_flip_options(command, *request);
  command.example("torquewright hopper flip specs/robot/hopper.json --task jump -o jump.csv");
  command.works([request] { return run_hopper_flip(*request); });
}

}  // namespace torquewright::cli
