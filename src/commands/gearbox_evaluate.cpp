// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "gearbox/problem_spec.hpp"
#include "gearbox/result_spec.hpp"
#include "gearbox/topology.hpp"
#include "io/atomic_file.hpp"
#include "io/provenance.hpp"
#include "src/commands/design_drawing.hpp"
#include "src/commands/gearbox_commands.hpp"
#include "src/interrupt.hpp"
#include "src/report/gearbox_text.hpp"

namespace torquewright::cli {
namespace {

struct EvaluateOptions {
  std::string problem_file;
  std::vector<std::int64_t> teeth;
  std::int64_t planet_count = 0;
  double module_mm = 0.0;
  std::string result_file;
  std::string drawing_file;
  bool json = false;
};

[[noreturn]] void refuse(const std::string& file, const std::string& message) {
  throw io::SpecError({{file, "", message}});
}

// The design that was asked for; what is left open is the problem's own where it has one choice.
gearbox::Design design_of(const EvaluateOptions& options, const gearbox::Problem& problem) {
  const gearbox::Topology& topology = *gearbox::find_topology(problem.topology);
  const std::size_t given = options.teeth.size();
  if (given != topology.free_gears && given != topology.gears.size()) {
    refuse(options.problem_file,
           fmt::format("--teeth has {} numbers; {} takes {} or {}: {}", given, topology.name,
                       topology.free_gears, topology.gears.size(),
                       fmt::join(topology.gears, ",")));
  }
  if (options.planet_count == 0 && problem.planet_count.size() > 1) {
    refuse(options.problem_file, "the problem lists several planet counts; say --planet-count N");
  }
  if (options.module_mm == 0.0 && problem.module_mm.size() > 1) {
    refuse(options.problem_file, "the problem lists several modules; say --module MM");
  }
  gearbox::Design design{options.teeth, problem.planet_count.front(), problem.module_mm.front()};
  if (given == topology.free_gears) design.teeth = topology.complete(options.teeth);
  if (options.planet_count != 0) design.planet_count = options.planet_count;
  if (options.module_mm != 0.0) design.module_mm = io::exact(options.module_mm);
  return design;
}

ExitCode run_evaluate(const EvaluateOptions& options) {
  const io::Document document = io::read_document(options.problem_file, "gearbox_problem");
  const gearbox::Problem problem = gearbox::read_problem(document);
  const gearbox::Design design = design_of(options, problem);
  const gearbox::Topology& topology = *gearbox::find_topology(problem.topology);
  const gearbox::DesignReport report = topology.evaluate(problem, design);
  catch_interrupt();
  const gearbox::Standing standing = gearbox::standing_of(problem, design, is_interrupted);

  nlohmann::ordered_json result = gearbox::evaluation_json(problem, report, standing);
  result["problem"] = document.root;
  result["tool"] = io::tool_provenance();
  result["inputs"] = io::input_provenance({&document, 1});
  const std::string json_text = result.dump(1) + "\n";
  if (!options.drawing_file.empty()) {
    io::write_whole_file(options.drawing_file, drawing_of(problem, design));
  }
  if (!options.result_file.empty()) io::write_whole_file(options.result_file, json_text);
  const std::string text =
      options.json ? json_text : report::evaluation_text(problem, report, standing);
  std::fputs(text.c_str(), stdout);
  return report.feasible() ? ExitCode::kPasses : ExitCode::kFails;
}

}  // namespace

void add_evaluate_command(CLI::App& gearbox, ExitCode& result) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command = gearbox.add_subcommand("evaluate", "Everything about one design");
  command->add_option("problem", options->problem_file, "Document of kind gearbox_problem")
      ->required();
  command->add_option("--teeth", options->teeth, "Free tooth counts, or all: 44,44,32")
      ->required()
      ->delimiter(',')
      ->check(CLI::Range(1, 1000000));
  command->add_option("--planet-count", options->planet_count, "Where the problem lists several")
      ->check(CLI::Range(2, 20));
  command->add_option("--module", options->module_mm, "In mm, where the problem lists several")
      ->check(CLI::Range(0.05, 25.0));
  command->add_option("-o,--output", options->result_file, "Write the evaluation as JSON here");
  command->add_option("--draw", options->drawing_file, "Draw the design to this SVG file");
  command->add_flag("--json", options->json, "Print the evaluation as JSON");
  command->footer(
      "Example:\n  torquewright gearbox evaluate specs/gearbox/d151_knee.json --teeth 44,44,32");
  command->callback([options, &result] { result = run_evaluate(*options); });
}

}  // namespace torquewright::cli
