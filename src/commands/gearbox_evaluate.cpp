// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "gearbox/problem_spec.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "io/refusal.hpp"
#include "src/commands/design_drawing.hpp"
#include "src/commands/gearbox_commands.hpp"
#include "src/interrupt.hpp"
#include "src/options/output_files.hpp"
#include "src/report/gearbox_text.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

/// Of any gear, as the schema of results demands.
constexpr std::int64_t kMostTeeth = 1'000'000;

struct EvaluateOptions {
  std::string problem_file;
  std::vector<std::int64_t> teeth;
  std::int64_t planet_count = 0;
  double module_mm = 0.0;
  OutputFiles outputs;
  bool json = false;
};

// The design that was asked for; what is left open is the problem's own where it has one choice.
gearbox::Design design_of(const EvaluateOptions& options, const gearbox::Problem& problem) {
  const gearbox::Topology& topology = *gearbox::find_topology(problem.topology);
  const std::size_t given = options.teeth.size();
  if (given != topology.free_gears && given != topology.gears.size()) {
    io::refuse(
        options.problem_file,
        fmt::format("--teeth has {} numbers; {} takes {} or {}: {}", given, topology.name,
                    topology.free_gears, topology.gears.size(), fmt::join(topology.gears, ",")));
  }
  if (options.planet_count == 0 && problem.planet_count.size() > 1) {
    io::refuse(options.problem_file,
               "the problem lists several planet counts; say --planet-count N");
  }
  if (options.module_mm == 0.0 && problem.module_mm.size() > 1) {
    io::refuse(options.problem_file, "the problem lists several modules; say --module MM");
  }
  gearbox::Design design{options.teeth, problem.planet_count.front(), problem.module_mm.front()};
  if (given == topology.free_gears) design.teeth = topology.complete(options.teeth);
  if (*std::max_element(design.teeth.begin(), design.teeth.end()) > kMostTeeth) {
    io::refuse(
        options.problem_file,
        fmt::format("--teeth {} makes rings of {} teeth; at most {} are allowed",
                    fmt::join(options.teeth, ","), fmt::join(design.teeth, ","), kMostTeeth));
  }
  if (options.planet_count != 0) design.planet_count = options.planet_count;
  if (options.module_mm != 0.0) design.module_mm = io::exact(options.module_mm);
  return design;
}

ExitCode run_evaluate(const EvaluateOptions& options) {
  const io::Document document = io::read_document(options.problem_file, "gearbox_problem");
  const gearbox::Problem problem = gearbox::read_problem(document);
  const gearbox::Design design = design_of(options, problem);
  const gearbox::Topology& topology = *gearbox::find_topology(problem.topology);
  check_outputs(options.outputs, options.problem_file);
  const gearbox::DesignReport report = topology.evaluate(problem, design);
  catch_interrupt();
  const gearbox::Standing standing = gearbox::standing_of(problem, design, is_interrupted);

  nlohmann::ordered_json result = gearbox::evaluation_json(problem, report, standing);
  result["problem"] = document.root;
  result["tool"] = io::tool_provenance();
  result["inputs"] = io::input_provenance({&document, 1});
  const std::string json_text = io::json_text(result);
  std::optional<std::string> drawing;
  if (!options.outputs.drawing.empty()) drawing = drawing_of(problem, design);
  write_outputs(options.outputs, json_text, drawing);
  print_result(options.json ? json_text : report::evaluation_text(problem, report, standing));
  if (!report.feasible()) return ExitCode::kFails;
  return is_interrupted() ? ExitCode::kUndecided : ExitCode::kPasses;
}

}  // namespace

// A range lets NaN pass: it is neither below nor above.
const CLI::Validator kNotNaN(
    [](const std::string& text) {
      return std::isnan(std::strtod(text.c_str(), nullptr)) ? text + " is not a number" : "";
    },
    "");

void add_evaluate_command(CLI::App& gearbox, ExitCode& result) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command = gearbox.add_subcommand("evaluate", "Everything about one design");
  command->add_option("problem", options->problem_file, "Document of kind gearbox_problem")
      ->required();
  command->add_option("--teeth", options->teeth, "Free tooth counts, or all: 44,44,32")
      ->required()
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(std::int64_t{1}, kMostTeeth));
  command->add_option("--planet-count", options->planet_count, "Where the problem lists several")
      ->check(CLI::Range(2, 20));
  command->add_option("--module", options->module_mm, "In mm, where the problem lists several")
      ->check(CLI::Range(0.05, 25.0) & kNotNaN);
  add_output_options(*command, options->outputs);
  command->add_flag("--json", options->json, "Print the evaluation as JSON");
  command->footer(
      "Example:\n  torquewright gearbox evaluate specs/gearbox/d151_knee.json --teeth 44,44,32");
  command->callback([options, &result] { result = run_evaluate(*options); });
}

}  // namespace torquewright::cli
