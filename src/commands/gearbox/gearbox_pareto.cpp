// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gearbox/synthesis_defaults_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/gearbox/gearbox_commands.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/interrupt.hpp"
#include "src/options/output_files.hpp"
#include "src/report/gearbox/front_text.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

using gearbox::Objective;

struct ParetoOptions {
  std::string problem_file;
  std::vector<std::string> objectives{"mass", "forward_efficiency"};
  std::int64_t points = 8;
  double time_limit_s = 0.0;
  std::string output_file;
  std::string plot_file;
  bool json = false;
};

Objective objective_of(const std::string& name) {
  for (const auto& [objective, known] : gearbox::kObjectives) {
    if (known == name) return objective;
  }
  std::string names;
  for (const auto& entry : gearbox::kObjectives) {
    names += (names.empty() ? "" : ", ") + std::string(entry.second);
  }
  io::refuse("--objectives", fmt::format("\"{}\" is not an objective; there are {}", name, names));
}

/// The problem with the first objective.
struct ParetoInputs {
  io::Document document;
  gearbox::Problem problem;
  Objective second = Objective::kForwardEfficiency;
};

ParetoInputs read(const ParetoOptions& options) {
  if (options.objectives.size() != 2 || options.objectives[0] == options.objectives[1]) {
    io::refuse("--objectives", "takes two that differ: mass,forward_efficiency");
  }
  const Objective first = objective_of(options.objectives[0]);
  const Objective second = objective_of(options.objectives[1]);
  if (second == Objective::kPaperCost) {
    io::refuse("--objectives", "\"paper_cost\" can stand first only");
  }
  io::Document document = gearbox::read_problem_document(options.problem_file);
  gearbox::Problem problem = gearbox::read_front_problem(document, first, second);
  check_written(named({options.output_file, options.plot_file}), {options.problem_file});
  require_svg("--plot", options.plot_file);
  return {std::move(document), std::move(problem), second};
}

gearbox::ShownFront compute(const ParetoOptions& options, const ParetoInputs& inputs) {
  using Clock = std::chrono::steady_clock;
  catch_interrupt();
  report::ProgressLine line;
  gearbox::FrontOptions wanted;
  wanted.points = static_cast<std::size_t>(options.points);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(options.time_limit_s));
  wanted.should_stop = [&] {
    return is_interrupted() || (options.time_limit_s > 0.0 && Clock::now() >= end);
  };
  wanted.report = [&](std::size_t points) { line.show(fmt::format("{} points proved", points)); };
  return {gearbox::design_front(inputs.problem, inputs.second, wanted), inputs.problem.objective,
          inputs.second};
}

ExitCode run_pareto(const ParetoOptions& options) {
  const ParetoInputs inputs = read(options);
  const gearbox::ShownFront shown = compute(options, inputs);
  const std::string json = result_text(gearbox::front_json(shown), {&inputs.document, 1});
  std::vector<io::FileContent> files;
  if (!options.output_file.empty()) files.push_back({options.output_file, json});
  if (!options.plot_file.empty() && !shown.front.points.empty()) {
    files.push_back({options.plot_file, report::front_svg(inputs.problem, shown)});
  }
  deliver(std::move(files),
          options.json ? json : for_window(report::front_text(inputs.problem, shown)));
  if (!shown.front.is_whole) return ExitCode::kUndecided;
  return shown.front.points.empty() ? ExitCode::kFails : ExitCode::kPasses;
}

}  // namespace

void add_pareto_command(command_line::Command& gearbox) {
  auto options = std::make_shared<ParetoOptions>();
  command_line::Command command = gearbox.add_command(
      "pareto", "Show what more of one quantity costs of another, each point proved");
  command.add_option("problem", options->problem_file, "Document of kind gearbox_problem")
      .required();
  command
      .add_option("--objectives", options->objectives,
                  "Two objectives: each point is the best of the first for a value of the second")
      .otherwise("mass,forward_efficiency")
      .separated_by_commas();
  command
      .add_option("--points", options->points,
                  "How many points are found where the problem has synthesis; without it all are")
      .otherwise("8")
      .integer_between(1, 1000);
  command.add_option("--time-limit", options->time_limit_s, "End after so many seconds")
      .otherwise("as long as it takes")
      .between(0.0, 1e9)
      .stated_as("time_limit_s");
  command.add_option("--plot", options->plot_file, "Draw the front into this SVG file")
      .names_a_file();
  command.add_option("-o,--output", options->output_file, "Write the front as JSON to this file")
      .names_a_file();
  command.add_flag("--json", options->json, "Print the front as JSON");
  command.example(
      "torquewright gearbox pareto specs/gearbox/d151_knee.json --objectives "
      "paper_cost,forward_efficiency");
  command.works([options] { return run_pareto(*options); });
}

}  // namespace torquewright::cli
