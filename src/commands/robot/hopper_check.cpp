// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "hopper/candidates/candidates.hpp"
#include "hopper/check/column_findings.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/robot/hopper_check_candidates.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"
#include "src/commands/robot/hopper_check_outputs.hpp"
#include "src/commands/robot/hopper_check_sweep.hpp"
#include "src/commands/robot/hopper_commands.hpp"
#include "src/commands/shared/verdict_code.hpp"
#include "src/commands/shared/watch.hpp"
#include "src/interrupt.hpp"
#include "src/options/output_files.hpp"
#include "src/report/parts/progress_line.hpp"

namespace torquewright::cli {
namespace {

/// Derives the rates that the motion lacks on the way.
hopper::HopperReport check_whole_body(const HopperCheckInputs& inputs, hopper::Motion& motion) {
  report::ProgressLine progress;
  hopper::CheckOptions check = inputs.check;
  check.on_progress = [&progress](double share) {
    progress.show(fmt::format("forces and torques: {:.0f} %", 100.0 * share));
  };
  return hopper::check_motion(inputs.robot.robot, motion, check);
}

/// Behind all others: they are notes.
void add_column_findings(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                         actuator::CheckReport& report) {
  std::vector<actuator::Finding> more =
      hopper::column_findings(inputs.robot.robot, motion_file(request));
  std::move(more.begin(), more.end(), std::back_inserter(report.findings));
}

std::vector<hopper::CandidateResult> try_by_threads(const HopperCheckRequest& request,
                                                    const HopperCheckInputs& inputs,
                                                    const HopperCheckFound& found) {
  report::ProgressLine progress;
  return hopper::try_candidates(
      inputs.robot.robot, found.motion, inputs.check, found.report, inputs.candidates,
      request.threads, [&progress](double share) {
        progress.show(fmt::format("trying candidates: {:.0f} %", 100.0 * share));
      });
}

/// False in a worker, which ends without a word.
bool try_candidates(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                    HopperCheckFound& found) {
  if (request.candidates_folder.empty()) return true;
  if (!asks_for_processes(request.sweep.points)) {
    found.candidates = try_by_threads(request, inputs, found);
    return true;
  }
  catch_interrupt();
  auto tried = try_by_processes(request, inputs, found);
  if (tried) found.candidates = std::move(*tried);
  return tried.has_value();
}

void require_points(const HopperCheckRequest& request) {
  if (!request.candidates_folder.empty()) return;
  const PointOptions& points = request.sweep.points;
  if (points.jobs > 0) io::refuse("--jobs", "is for --sweep or --candidates");
  if (!points.journal_file.empty()) {
    io::refuse("--sweep-journal", "is for --sweep or --candidates");
  }
}

ExitCode check_once(const HopperCheckRequest& request) {
  require_points(request);
  require_outputs(request);
  auto [inputs, motion] = read_inputs(request);
  check_output_files(request);  // now that the robot's and the candidates' files are known
  require_page("--report", request.report_file);
  require_outside(request.candidates_folder,
                  named({request.figures_file, request.series_file, request.output_file}));
  HopperCheckFound found;
  found.motion = std::move(motion);
  found.report = check_whole_body(inputs, found.motion);
  add_column_findings(request, inputs, found.report.check);
  if (!try_candidates(request, inputs, found)) return ExitCode::kPasses;
  write_outputs(request, inputs, found);
  return is_interrupted() ? ExitCode::kUndecided : verdict_code(found.report.check.verdict);
}

ExitCode run_hopper_check(const HopperCheckRequest& request) {
  if (!request.sweep.axes.empty()) return run_hopper_check_sweep(request);
  const auto work = [&request] { return check_once(request); };
  return request.watch ? watch(work) : work();
}

}  // namespace

void add_hopper_check_command(command_line::Command& group) {
  auto request = std::make_shared<HopperCheckRequest>();
  command_line::Command command = group.add_command("check", "Can this robot do this motion?");
  request->command_group = group.declared().name;
  add_hopper_check_options(command, *request);
  command.example(
      fmt::format("torquewright {} check specs/robot/hopper.json specs/trajectory/hopper_flip.csv",
                  group.declared().name));
  command.works([request] { return run_hopper_check(*request); });
}

}  // namespace torquewright::cli
