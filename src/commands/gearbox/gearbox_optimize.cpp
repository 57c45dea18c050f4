// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "gearbox/problem_spec.hpp"
#include "gearbox/search/search.hpp"
#include "gearbox/synthesis_defaults_spec.hpp"
#include "gearbox/verification/verification_json.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/gearbox/design_drawing.hpp"
#include "src/commands/gearbox/gearbox_commands.hpp"
#include "src/commands/gearbox/gearbox_outputs.hpp"
#include "src/commands/gearbox/gearbox_result_json.hpp"
#include "src/commands/gearbox/gearbox_synthesis.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/interrupt.hpp"
#include "src/loudness.hpp"
#include "src/report/gearbox/design_text.hpp"
#include "src/report/gearbox/gearbox_text.hpp"
#include "src/report/gearbox/proof_text.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

using optimization::RelaxationUse;

const std::map<std::string, RelaxationUse> kRelaxationUses{{"auto", RelaxationUse::kAuto},
                                                           {"always", RelaxationUse::kAlways},
                                                           {"never", RelaxationUse::kNever}};

// True once the user or the clock ends the search.
std::function<bool()> end_of_search(const OptimizeRequest& request) {
  if (request.time_limit_s == 0.0) return is_interrupted;
  using Clock = std::chrono::steady_clock;
  const auto limit = std::chrono::duration<double>(request.time_limit_s);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
  return [end] { return is_interrupted() || Clock::now() >= end; };
}

gearbox::DesignSearchOptions search_options(const OptimizeRequest& request,
                                            const std::function<bool()>& is_over,
                                            report::ProgressLine& line) {
  gearbox::DesignSearchOptions result;
  result.top = request.top;
  result.relaxation = kRelaxationUses.at(request.relaxation);
  if (request.max_nodes > 0) result.max_nodes = request.max_nodes;
  result.should_stop = is_over;
  result.report = [&line](const optimization::Progress& progress) {
    line.show(fmt::format(
        "{} parts of the search done, {} open, {} designs kept, best {:.8g}, bound {:.8g}",
        progress.nodes, progress.open, progress.found, progress.best_cost, progress.bound));
  };
  return result;
}

ReadProblem read(const OptimizeRequest& request) {
  io::Document document = gearbox::read_problem_document(request.problem_file);
  gearbox::Problem problem = gearbox::read_open_problem(document);
  check_outputs(request.outputs, request.problem_file);
  if (problem.synthesis) return {std::move(document), std::move(problem)};
  if (request.relaxation == "always" && !gearbox::can_be_relaxed(problem)) {
    io::refuse("--relaxation",
               fmt::format("\"always\" cannot help with the objective {}, of which no convex bound "
                           "is known; \"auto\" and \"never\" search by intervals",
                           gearbox::objective_name(problem.objective)));
  }
  return {std::move(document), std::move(problem)};
}

/// What was found, as text and as the document of which the proof is checked.
struct OptimizeAnswer {
  gearbox::DesignSearchResult found;
  std::string json;
  std::string text;
  std::optional<gearbox::Verification> check;
  std::optional<std::string> drawing;  ///< Of the best design, where one was asked for.
};

OptimizeAnswer compute(const OptimizeRequest& request, const ReadProblem& inputs) {
  catch_interrupt();
  OptimizeAnswer answer;
  const auto start = std::chrono::steady_clock::now();
  {
    report::ProgressLine line;
    answer.found =
        gearbox::optimize(inputs.problem, search_options(request, end_of_search(request), line));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  answer.json = optimization_json(request, inputs, answer.found, seconds.count());
  answer.text =
      report::optimization_text(inputs.problem, answer.found, request.all || loudness().is_verbose);
  if (request.timing) answer.text += fmt::format("Search time: {:.4f} s\n", seconds.count());
  if (request.verify) {
    catch_interrupt();  // what ended the search does not end the check
    answer.check = gearbox::verify(inputs.problem, as_read(answer.json), is_interrupted);
    answer.text += report::proof_text(*answer.check);
  }
  if (!request.outputs.drawing.empty() && !answer.found.designs.empty()) {
    answer.drawing = drawing_of(inputs.problem, answer.found.designs.front());
  }
  return answer;
}

/// What one does with the screen; nothing where all was asked for, or there is no design.
std::string next_line(const OptimizeRequest& request, const gearbox::Problem& problem,
                      const OptimizeAnswer& answer) {
  if (request.all || loudness().is_verbose || answer.found.designs.empty()) return "";
  return report::next_text(request.problem_file, problem);
}

void write(const OptimizeRequest& request, const gearbox::Problem& problem,
           const OptimizeAnswer& answer) {
  write_outputs(request.outputs, answer.json, answer.drawing,
                !request.json  ? for_window(answer.text + next_line(request, problem, answer),
                                            report::optimization_answer(problem, answer.found))
                : answer.check ? with_verdict(answer.json, *answer.check)
                               : answer.json);
}

ExitCode exit_code_of(const OptimizeAnswer& answer) {
  if (answer.check && answer.check->is_ended) return ExitCode::kUndecided;
  if (answer.check && !answer.check->is_accepted) return ExitCode::kFails;
  switch (answer.found.status) {
    case gearbox::DesignSearchStatus::kOptimal:
      return ExitCode::kPasses;
    case gearbox::DesignSearchStatus::kInfeasible:
      return ExitCode::kFails;
    case gearbox::DesignSearchStatus::kLimit:
      break;
  }
  return ExitCode::kUndecided;
}

ExitCode run_optimize(const OptimizeRequest& request) {
  const ReadProblem inputs = read(request);
  if (inputs.problem.synthesis) {
    catch_interrupt();
    return run_synthesis(request, inputs, end_of_search(request));
  }
  const OptimizeAnswer answer = compute(request, inputs);
  write(request, inputs.problem, answer);
  return exit_code_of(answer);
}

}  // namespace

void add_optimize_command(command_line::Command& gearbox) {
  auto request = std::make_shared<OptimizeRequest>();
  command_line::Command command =
      gearbox.add_command("optimize", "Find the best gearbox of a problem, and prove it");
  add_optimize_options(command, *request);
  command.example("torquewright gearbox optimize specs/gearbox/d151_knee.json --verify");
  command.works([request] { return run_optimize(*request); });
}

}  // namespace torquewright::cli
