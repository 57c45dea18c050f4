// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "hopper/candidates/candidates.hpp"
#include "src/commands/hopper_check_inputs.hpp"
#include "src/commands/hopper_check_outputs.hpp"
#include "src/commands/hopper_check_sweep.hpp"
#include "src/commands/hopper_commands.hpp"
#include "src/commands/verdict_code.hpp"
#include "src/report/progress_line.hpp"

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

std::vector<hopper::CandidateResult> try_shelf(const HopperCheckRequest& request,
                                               const HopperCheckInputs& inputs,
                                               const HopperCheckFound& found) {
  if (request.candidates_folder.empty()) return {};
  report::ProgressLine progress;
  return hopper::try_candidates(
      inputs.robot.robot, found.motion, inputs.check, found.report, inputs.shelf, request.threads,
      [&progress](double share) {
        progress.show(fmt::format("trying candidates: {:.0f} %", 100.0 * share));
      });
}

HopperCheckFound compute(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                         hopper::Motion motion) {
  HopperCheckFound found;
  found.motion = std::move(motion);
  found.report = check_whole_body(inputs, found.motion);
  found.candidates = try_shelf(request, inputs, found);
  return found;
}

ExitCode run_hopper_check(const HopperCheckRequest& request) {
  if (!request.sweep.axes.empty()) return run_hopper_check_sweep(request);
  require_outputs(request);
  auto [inputs, motion] = read_inputs(request);
  check_output_files(request);  // now that the robot's and the candidates' files are known
  const HopperCheckFound found = compute(request, inputs, std::move(motion));
  write_outputs(request, inputs, found);
  return verdict_code(found.report.check.verdict);
}

}  // namespace

void add_hopper_check_command(command_line::Command& hopper) {
  auto request = std::make_shared<HopperCheckRequest>();
  command_line::Command command = hopper.add_command("check", "Can this robot do this motion?");
  add_hopper_check_options(command, *request);
  command.example(
      "torquewright hopper check specs/robot/hopper.json "
      "specs/trajectory/hopper_flip.csv");
  command.works([request] { return run_hopper_check(*request); });
}

}  // namespace torquewright::cli
