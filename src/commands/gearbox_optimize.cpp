// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "gearbox/problem_spec.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/search/search.hpp"
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

gearbox::DesignSearchOptions synthesis_options(const OptimizeOptions& options,
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

ExitCode exit_code(gearbox::DesignSearchStatus status) {
  switch (status) {
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
  const io::Document document = io::read_document(options.problem_file, "gearbox_problem");
  const gearbox::Problem problem = gearbox::read_problem(document);
  check_outputs(options.outputs, options.problem_file);
  catch_interrupt();
  const auto start = std::chrono::steady_clock::now();
  gearbox::DesignSearchResult found;
  {
    report::ProgressLine line;
    found = gearbox::optimize(problem, synthesis_options(options, line));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

  nlohmann::ordered_json result = gearbox::result_json(problem, found);
  if (options.timing) result["search"]["seconds"] = seconds.count();
  result["problem"] = document.root;
  result["tool"] = io::tool_provenance();
  result["inputs"] = io::input_provenance({&document, 1});
  result["options"] = non_default_options(options);

  const std::string json_text = io::json_text(result);
  ExitCode code = exit_code(found.status);
  std::string text = report::optimization_text(problem, found);
  if (options.timing) text += fmt::format("Search time: {:.4f} s\n", seconds.count());
  if (options.verify) {
    const ProofCheck check = check_proof(problem, nlohmann::json::parse(json_text));
    text += check.text;
    if (!check.is_accepted) code = ExitCode::kFails;
  }
  std::optional<std::string> drawing;
  if (!options.outputs.drawing.empty() && !found.designs.empty()) {
    drawing = drawing_of(problem, found.designs.front());
  }
  write_outputs(options.outputs, json_text, drawing);
  print_result(options.json ? json_text : text);
  return code;
}

}  // namespace

void add_optimize_command(CLI::App& gearbox, ExitCode& result) {
  auto options = std::make_shared<OptimizeOptions>();
  CLI::App* command = gearbox.add_subcommand("optimize", "The best gearbox of a problem, proved");
  command->add_option("problem", options->problem_file, "Document of kind gearbox_problem")
      ->required();
  add_output_options(*command, options->outputs);
  command->add_option("--top", options->top, "How many of the best designs (default 1)")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--relaxation", options->relaxation, "When Ipopt is asked (default auto)")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  command->add_option("--max-nodes", options->max_nodes, "End the search after so many boxes")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 60));
  command->add_flag("--verify", options->verify, "Check the proof with the independent checker");
  command->add_flag("--json", options->json, "Print the result as JSON");
  command->add_flag("--timing", options->timing, "State the seconds (runs then differ in bytes)");
  command->footer(
      "Example:\n  torquewright gearbox optimize specs/gearbox/d151_knee.json --verify");
  command->callback([options, &result] { result = run_optimize(*options); });
}

}  // namespace torquewright::cli
