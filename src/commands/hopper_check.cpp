// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <vector>

#include "hopper/candidates/candidates.hpp"
#include "src/commands/hopper_check_inputs.hpp"
#include "src/commands/hopper_check_outputs.hpp"
#include "src/commands/hopper_commands.hpp"
#include "src/commands/verdict_code.hpp"
#include "src/report/progress_line.hpp"

namespace torquewright::cli {
namespace {

/// Derives the rates that the motion lacks on the way.
hopper::HopperReport check_whole_body(HopperCheckInputs& inputs) {
  report::ProgressLine progress;
  hopper::CheckOptions check = inputs.check;
  check.on_progress = [&progress](double share) {
    progress.show(fmt::format("forces and torques: {:.0f} %", 100.0 * share));
  };
  return hopper::check_motion(inputs.robot.robot, inputs.motion, check);
}

std::vector<hopper::CandidateResult> try_shelf(const HopperCheckRequest& request,
                                               const HopperCheckInputs& inputs) {
  if (request.candidates_folder.empty()) return {};
  report::ProgressLine progress;
  return hopper::try_candidates(
      inputs.robot.robot, inputs.motion, inputs.check, inputs.shelf, request.threads,
      [&progress](double share) {
        progress.show(fmt::format("trying candidates: {:.0f} %", 100.0 * share));
      });
}

HopperCheckFound compute(const HopperCheckRequest& request, HopperCheckInputs& inputs) {
  HopperCheckFound found;
  found.report = check_whole_body(inputs);
  found.candidates = try_shelf(request, inputs);
  return found;
}

ExitCode run_hopper_check(const HopperCheckRequest& request) {
  require_outputs(request);
  HopperCheckInputs inputs = read_inputs(request);
  const HopperCheckFound found = compute(request, inputs);
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
