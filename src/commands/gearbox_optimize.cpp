// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "gearbox/problem_spec.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/search/search.hpp"
#include "io/document.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "src/commands/design_drawing.hpp"
#include "src/commands/gearbox_commands.hpp"
#include "src/commands/proof_check.hpp"
#include "src/interrupt.hpp"
#include "src/options/output_files.hpp"
#include "src/report/gearbox_text.hpp"
#include "src/report/progress_line.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

using optimization::RelaxationUse;

const std::map<std::string, RelaxationUse> kRelaxationUses{{"auto", RelaxationUse::kAuto},
                                                           {"always", RelaxationUse::kAlways},
                                                           {"never", RelaxationUse::kNever}};

struct OptimizeOptions {
  std::string problem_file;
  OutputFiles outputs;
  std::size_t top = 1;
  std::string relaxation = "auto";
  std::int64_t max_nodes = 0;
  bool verify = false;
  bool json = false;
  bool timing = false;
};

nlohmann::ordered_json non_default_options(const OptimizeOptions& options) {
  nlohmann::ordered_json changed = nlohmann::ordered_json::object();
  if (options.top != 1) changed["top"] = options.top;
  if (options.relaxation != "auto") changed["relaxation"] = options.relaxation;
  if (options.max_nodes != 0) changed["max_nodes"] = options.max_nodes;
  return changed;
}

gearbox::DesignSearchOptions search_options(const OptimizeOptions& options,
                                            report::ProgressLine& line) {
  gearbox::DesignSearchOptions result;
  result.top = options.top;
  result.relaxation = kRelaxationUses.at(options.relaxation);
  if (options.max_nodes > 0) result.max_nodes = options.max_nodes;
  result.should_stop = is_interrupted;
  result.report = [&line](const optimization::Progress& progress) {
    line.show(fmt::format("{} boxes done, {} open, {} designs kept, best {:.8g}, bound {:.8g}",
                          progress.nodes, progress.open, progress.found, progress.best_cost,
                          progress.bound));
  };
  return result;
}

struct OptimizeInputs {
  io::Document document;
  gearbox::Problem problem;
};

OptimizeInputs read(const OptimizeOptions& options) {
  io::Document document = io::read_document(options.problem_file, "gearbox_problem");
  gearbox::Problem problem = gearbox::read_problem(document);
  check_outputs(options.outputs, options.problem_file);
  return {std::move(document), std::move(problem)};
}

/// What was found, as text and as the document of which the proof is checked.
struct OptimizeAnswer {
  gearbox::DesignSearchResult found;
  std::string json;
  std::string text;
  std::optional<ProofCheck> check;
};

std::string json_text(const OptimizeOptions& options, const OptimizeInputs& inputs,
                      const gearbox::DesignSearchResult& found, double seconds) {
  nlohmann::ordered_json result = gearbox::result_json(inputs.problem, found);
  if (options.timing) result["search"]["seconds"] = seconds;
  result["problem"] = inputs.document.root;
  result["tool"] = io::tool_provenance();
  result["inputs"] = io::input_provenance({&inputs.document, 1});
  result["options"] = non_default_options(options);
  return io::json_text(result);
}

OptimizeAnswer compute(const OptimizeOptions& options, const OptimizeInputs& inputs) {
  catch_interrupt();
  OptimizeAnswer answer;
  const auto start = std::chrono::steady_clock::now();
  {
    report::ProgressLine line;
    answer.found = gearbox::optimize(inputs.problem, search_options(options, line));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  answer.json = json_text(options, inputs, answer.found, seconds.count());
  answer.text = report::optimization_text(inputs.problem, answer.found);
  if (options.timing) answer.text += fmt::format("Search time: {:.4f} s\n", seconds.count());
  if (options.verify) {
    answer.check = check_proof(inputs.problem, nlohmann::json::parse(answer.json));
    answer.text += answer.check->text;
  }
  return answer;
}

void write(const OptimizeOptions& options, const OptimizeInputs& inputs,
           const OptimizeAnswer& answer) {
  std::optional<std::string> drawing;
  if (!options.outputs.drawing.empty() && !answer.found.designs.empty()) {
    drawing = drawing_of(inputs.problem, answer.found.designs.front());
  }
  write_outputs(options.outputs, answer.json, drawing);
  print_result(options.json ? answer.json : answer.text);
}

ExitCode exit_code_of(const OptimizeAnswer& answer) {
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

ExitCode run_optimize(const OptimizeOptions& options) {
  const OptimizeInputs inputs = read(options);
  const OptimizeAnswer answer = compute(options, inputs);
  write(options, inputs, answer);
  return exit_code_of(answer);
}

}  // namespace

void add_optimize_command(command_line::Command& gearbox) {
  auto options = std::make_shared<OptimizeOptions>();
  command_line::Command command =
      gearbox.add_command("optimize", "The best gearbox of a problem, proved");
  command.add_option("problem", options->problem_file, "Document of kind gearbox_problem")
      .required();
  add_output_options(command, options->outputs);
  command.add_option("--top", options->top, "How many of the best designs (default 1)")
      .integer_between(1, 1000000);
  command.add_option("--relaxation", options->relaxation, "When Ipopt is asked (default auto)")
      .one_of({"auto", "always", "never"});
  command.add_option("--max-nodes", options->max_nodes, "End the search after so many boxes")
      .integer_between(1, std::int64_t{1} << 60);
  command.add_flag("--verify", options->verify, "Check the proof with the independent checker");
  command.add_flag("--json", options->json, "Print the result as JSON");
  command.add_flag("--timing", options->timing, "State the seconds (runs then differ in bytes)");
  command.example("torquewright gearbox optimize specs/gearbox/d151_knee.json --verify");
  command.works([options] { return run_optimize(*options); });
}

}  // namespace torquewright::cli
