// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_check_candidates.hpp"

#include <fmt/format.h>

#include <utility>

#include "hopper/candidates/candidates_spec.hpp"
#include "src/commands/robot/hopper_check_json.hpp"
#include "src/interrupt.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/sweep/sweep.hpp"

namespace torquewright::cli {
namespace {

hopper::CandidateResult result_of(const hopper::CandidateTrials& trials, std::size_t number,
                                  const std::optional<sweep::Answer>& answer) {
  if (!answer) return trials.untried(number, "not tried: ended before");
  if (answer->is_lost) return trials.untried(number, "lost: " + answer->why);
  return hopper::candidate_of(answer->row);
}

}  // namespace

std::optional<std::vector<hopper::CandidateResult>> try_by_processes(
    const HopperCheckRequest& request, const HopperCheckInputs& inputs,
    const HopperCheckFound& found) {
  const hopper::CandidateTrials trials(inputs.robot.robot, found.motion, inputs.check, found.report,
                                       inputs.candidates);
  sweep::Request points;
  for (std::size_t i = 0; i < trials.size(); ++i) points.points.push_back(trials.name_of(i));
  points.fingerprint = hopper_check_fingerprint(request, inputs, found.motion);
  points.journal_file = journal_of(request.sweep.points, request.output_file);
  points.jobs = request.sweep.points.jobs;
  report::ProgressLine progress;
  const auto outcome = sweep::run_sweep(
      points, [&](std::size_t number) { return hopper::candidate_text(trials.result_of(number)); },
      {is_interrupted, [&](std::size_t done, std::size_t all) {
         progress.show(fmt::format("candidates: {} of {}", done, all));
       }});
  if (!outcome) return std::nullopt;
  std::vector<hopper::CandidateResult> results;
  for (std::size_t i = 0; i < outcome->answers.size(); ++i) {
    results.push_back(result_of(trials, i, outcome->answers[i]));
  }
  return hopper::ranked(std::move(results));
}

}  // namespace torquewright::cli
