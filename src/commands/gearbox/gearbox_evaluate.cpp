// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearbox/problem_spec.hpp"
#include "gearbox/search/ranking.hpp"
#include "gearbox/synthesis_defaults_spec.hpp"
#include "gearbox/topologies/shifted_train.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/gearbox/design_drawing.hpp"
#include "src/commands/gearbox/gearbox_commands.hpp"
#include "src/commands/gearbox/gearbox_outputs.hpp"
#include "src/commands/gearbox/gearbox_result_json.hpp"
#include "src/interrupt.hpp"
#include "src/report/gearbox/gearbox_text.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

/// Of any gear, as the schema of results demands.
constexpr std::int64_t kMostTeeth = 1'000'000;

struct EvaluateOptions {
  std::string problem_file;
  std::vector<std::int64_t> teeth;
  std::int64_t planet_count = 0;
  double module_mm = 0.0;
  std::vector<double> profile_shift;  // Empty: none.
  double layer_2_module_mm = 0.0;     // 0: the same.
  OutputFiles outputs;
  bool rank = false;
  bool json = false;
};

/// Of each search for the standing, where nobody asked for it: a tenth of a second at most.
constexpr std::int64_t kCheapBoxes = 300;

/// All shifts; where the rings' are left open they close the centre distance.
std::vector<double> all_shifts(const EvaluateOptions& options, const gearbox::Problem& problem,
                               const gearbox::Topology& topology, const gearbox::Design& design) {
  const std::size_t given = options.profile_shift.size();
  if (given == topology.gears.size()) return options.profile_shift;
  if (given != 0 && given != topology.free_gears) {
    io::refuse("--profile-shift",
               fmt::format("has {} numbers; {} takes {} (the rings' close the centre distance) or "
                           "{}: {}",
                           given, topology.name, topology.free_gears, topology.gears.size(),
                           fmt::join(topology.gears, ",")));
  }
  gearbox::Design open = design;
  open.profile_shift = options.profile_shift;
  open.profile_shift.resize(topology.gears.size(), 0.0);
  const std::string objection = gearbox::shift_objection(problem, open);
  if (!objection.empty()) io::refuse("--profile-shift", objection);
  const auto closed = gearbox::coaxial_shifts(gearbox::gear_train(problem, open));
  return closed.value_or(open.profile_shift);  // What cannot close, coaxial.RING says.
}

/// Shifts and second module, where they are others than those of the search.
void set_shifts(const EvaluateOptions& options, const gearbox::Problem& problem,
                const gearbox::Topology& topology, gearbox::Design& design) {
  if (options.layer_2_module_mm != 0.0) {
    if (topology.layer_count() < 2) {
      io::refuse("--layer-2-module", fmt::format("{} has one layer", topology.name));
    }
    const io::Rational module_mm = io::exact(options.layer_2_module_mm);
    if (module_mm != design.module_mm) design.layer_2_module_mm = module_mm;
  }
  if (options.profile_shift.empty() && !design.layer_2_module_mm) return;
  design.profile_shift = all_shifts(options, problem, topology, design);
  const bool is_any = std::any_of(design.profile_shift.begin(), design.profile_shift.end(),
                                  [](double shift) { return shift != 0.0; });
  if (!is_any && !design.layer_2_module_mm) design.profile_shift.clear();
  const std::string objection = gearbox::shift_objection(problem, design);
  if (!objection.empty()) io::refuse("--profile-shift", objection);
  if (options.rank && design.is_shifted()) {
    io::refuse("--rank", "the search knows gears without profile shift and of one module only");
  }
}

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
  set_shifts(options, problem, topology, design);
  return design;
}

struct EvaluateInputs {
  ReadProblem read;
  gearbox::Design design;
};

EvaluateInputs read(const EvaluateOptions& options) {
  io::Document document = gearbox::read_problem_document(options.problem_file);
  gearbox::Problem problem = gearbox::read_problem(document);
  gearbox::Design design = design_of(options, problem);
  check_outputs(options.outputs, options.problem_file);
  return {{std::move(document), std::move(problem)}, std::move(design)};
}

/// The design itself, and where it stands among all others.
struct Evaluation {
  gearbox::DesignReport report;
  gearbox::Standing standing;
  std::optional<std::string> drawing;  ///< Where one was asked for.
};

gearbox::StandingOptions standing_options(const EvaluateOptions& options,
                                          report::ProgressLine& line) {
  gearbox::StandingOptions result;
  if (!options.rank) result.max_boxes = kCheapBoxes;
  result.should_stop = is_interrupted;
  result.report = [&line](const char* sought, std::int64_t boxes, std::int64_t found) {
    line.show(
        fmt::format("seeking {}: {} parts of the search done, {} found", sought, boxes, found));
  };
  return result;
}

Evaluation compute(const EvaluateOptions& options, const EvaluateInputs& inputs) {
  const gearbox::Problem& problem = inputs.read.problem;
  Evaluation found;
  found.report = gearbox::find_topology(problem.topology)->evaluate(problem, inputs.design);
  catch_interrupt();
  if (!inputs.design.is_shifted() && !problem.synthesis) {
    report::ProgressLine line;
    found.standing = gearbox::standing_of(problem, inputs.design, standing_options(options, line));
  }
  if (!options.outputs.drawing.empty()) found.drawing = drawing_of(problem, inputs.design);
  return found;
}

void write(const EvaluateOptions& options, const EvaluateInputs& inputs, const Evaluation& found) {
  const std::string json = evaluation_json(inputs.read, found.report, found.standing);
  write_outputs(options.outputs, json, found.drawing,
                options.json ? json
                             : for_window(report::evaluation_text(inputs.read.problem, found.report,
                                                                  found.standing)));
}

ExitCode run_evaluate(const EvaluateOptions& options) {
  const EvaluateInputs inputs = read(options);
  const Evaluation found = compute(options, inputs);
  write(options, inputs, found);
  if (!found.report.feasible()) return ExitCode::kFails;
  return is_interrupted() ? ExitCode::kUndecided : ExitCode::kPasses;
}

}  // namespace

void add_evaluate_command(command_line::Command& gearbox) {
  auto options = std::make_shared<EvaluateOptions>();
  command_line::Command command =
      gearbox.add_command("evaluate", "Compute everything about one design");
  command.add_option("problem", options->problem_file, "Document of kind gearbox_problem")
      .required();
  command
      .add_option("--teeth", options->teeth,
                  "Tooth counts of the design, those of sun and planets or all: 44,44,32")
      .required()
      .separated_by_commas()
      .one_value_each()
      .integer_between(1, kMostTeeth);
  command
      .add_option("--planet-count", options->planet_count,
                  "Planets of the design; needed where the problem lists several")
      .otherwise("the problem's, where it has one")
      .integer_between(2, 20);
  command
      .add_option("--module", options->module_mm,
                  "Module of the design, in mm; needed where the problem lists several")
      .otherwise("the problem's, where it has one")
      .between(0.05, 25.0);
  add_output_options(command, options->outputs);
  command
      .add_option("--profile-shift", options->profile_shift,
                  "By how much each gear is shifted, in modules: 0.48,0.76,0.54; where the rings' "
                  "are left out, they close the centre distance")
      .otherwise("none is shifted")
      .separated_by_commas()
      .one_value_each()
      .between(-2.0, 5.0);
  command
      .add_option(
          "--layer-2-module", options->layer_2_module_mm,
          "Module of planet 2 and the output ring, in mm, where it differs from the first layer's")
      .otherwise("that of the first layer")
      .between(0.05, 25.0);
  command.add_flag(
      "--rank", options->rank,
      "Rank it among all designs however long that takes (else only where it is cheap)");
  command.add_flag("--json", options->json, "Print the evaluation as JSON");
  command.example("torquewright gearbox evaluate specs/gearbox/d151_knee.json --teeth 44,44,32");
  command.works([options] { return run_evaluate(*options); });
}

}  // namespace torquewright::cli
