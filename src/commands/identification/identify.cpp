// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identification/forward/candidates.hpp"
#include "identification/outputs/output.hpp"
#include "identification/robot/robot_output.hpp"
#include "io/files/atomic_file.hpp"
#include "io/text/nearest.hpp"
#include "io/text/one_line.hpp"
#include "io/text/wording.hpp"
#include "src/commands/identification/identify_commands.hpp"
#include "src/commands/identification/identify_inputs.hpp"
#include "src/commands/identification/identify_json.hpp"
#include "src/commands/identification/refined_actuators.hpp"
#include "src/commands/identification/refined_robot.hpp"
#include "src/commands/identification/simulated_robot.hpp"
#include "src/interrupt.hpp"
#include "src/options/output_files.hpp"
#include "src/report/identification/identification_html.hpp"
#include "src/report/identification/identification_text.hpp"
#include "src/report/identification/simulated_text.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

using identification::Identification;

/// What was found, and what follows from it for the actuators.
struct IdentifyFound {
  Identification identification;
  RefinedActuators refined;
  std::vector<report::RegionSection> regions;  ///< For the page, where one was asked for.
  /// Of a robot whose controllers' laws are stated.
  std::optional<report::RobotReport> robot;
  std::optional<RefinedRobot> refined_robot;
};

Identification identification_of(const IdentifyRequest& request, const IdentifyInputs& inputs) {
  report::ProgressLine progress;
  identification::IdentifyOptions options;
  options.select = request.select;
  options.analysis.only = request.only;
  options.analysis.without = request.without;
  options.analysis.tolerance = request.tolerance;
  options.analysis.before_each_fit = leave_if_interrupted;
  options.empirical = request.empirical;
  options.progress = [&progress](const std::string& what, double share) {
    progress.show(fmt::format("{}: {:.0f} %", what, 100.0 * share));
  };
  return identification::identify({request.logs.begin(), request.logs.end()}, inputs.rig,
                                  inputs.actuators, options);
}

/// An effect that is misspelt would be asked, or not asked, in silence.
void require_names(const std::string& option, const std::vector<std::string>& names) {
  const std::vector<std::string> known = identification::nameable_effects();
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::optional<std::string> near = io::nearest(name, known);
    command_line::refuse(fmt::format(
        "{}: no effect is called \"{}\"; {}", option, name,
        near ? fmt::format("did you mean \"{}\"?", *near) : "allowed are " + io::listed(known)));
  }
}

/// What may be named and may not be named is a mistake in one of the two.
void require_no_contradiction(const IdentifyRequest& request) {
  for (const std::string& name : request.only) {
    if (std::find(request.without.begin(), request.without.end(), name) == request.without.end())
      continue;
    command_line::refuse(
        fmt::format("--only and --without: \"{}\" is in both; allowed is one of them", name));
  }
}

/// What adds to a report that goes nowhere would be dropped in silence.
void require_report_for_tables(const IdentifyRequest& request) {
  const bool has_report = request.as.empty() || !request.outputs.empty();
  if (!request.empirical || has_report || !request.report_file.empty()) return;
  command_line::refuse(
      "--empirical: adds a table to the report, in whose place --as prints numbers; allowed beside "
      "it with --output or --report");
}

IdentifyInputs read(const IdentifyRequest& request) {
  require_log_options(request);
  require_report_for_tables(request);
  require_names("--only", request.only);
  require_names("--without", request.without);
  require_no_contradiction(request);
  const bool is_of_robot = identification::find_robot_output(request.as) != nullptr;
  if (!request.as.empty() && !is_of_robot) (void)identification::output_of(request.as);
  IdentifyInputs inputs = read_inputs(request);
  if (is_of_robot && inputs.rig.load.type != identification::LoadType::kRobot) {
    command_line::refuse(fmt::format(
        "--as {}: writes a robot; allowed where the rig's \"load\" is one", request.as));
  }
  require_page("--report", request.report_file);
  if (!request.report_file.empty()) report::require_gnuplot("--report");  // refuse early
  return inputs;
}

IdentifyFound compute(const IdentifyRequest& request, const IdentifyInputs& inputs) {
  IdentifyFound found;
  std::optional<identification::RobotStudy> study = study_of_gains(request, inputs);
  IdentifyInputs known = inputs;
  if (study) {
    const auto& controllers = study->fit.model.controllers;
    known.rig.controllers.assign(controllers.begin(), controllers.end());
  }
  found.identification = identification_of(request, known);
  study = judged_by_simulation(request, inputs, std::move(study), found.identification);
  found.refined = refined_actuators(known, found.identification);
  if (!inputs.refined.empty() || !request.as.empty())
    judge_as_written(request, known, found.identification, found.refined);
  const std::string not_simulated = not_simulated_sentence(inputs);
  if (!not_simulated.empty())
    found.identification.findings.push_back({identification::Weight::kNote, not_simulated});
  found.robot =
      simulated_robot(request, inputs, found.identification, found.refined, std::move(study));
  if (found.robot)
    found.refined_robot = refined_robot(request, inputs, found.identification, *found.robot);
  if (!request.report_file.empty()) found.regions = region_sections(inputs, found.refined);
  return found;
}

/// In place of the report: what was found, for another program. On stderr where nothing was.
std::string output_text(const IdentifyRequest& request, const IdentifyInputs& inputs,
                        const IdentifyFound& found) {
  const identification::Output& output = identification::output_of(request.as);
  if (found.refined.of_joints.empty()) {
    std::fprintf(stderr, "%s: nothing sure to add; these are the actuator's numbers as stated\n",
                 request.as.c_str());
  }
  std::string text;
  for (std::size_t i = 0; i < inputs.actuators.size(); ++i) {
    const std::string& joint = inputs.actuators[i].joint;
    if (!joint.empty()) text += joint + "\n";
    const actuator::Actuator& actuator = i < found.refined.of_joints.size()
                                             ? found.refined.of_joints[i].read.actuator
                                             : inputs.actuators[i].nominal.actuator;
    text += output.write({actuator, inputs.rig.load});
  }
  return text;
}

ExitCode exit_code_of(identification::Verdict verdict) {
  switch (verdict) {
    case identification::Verdict::kExplained:
    case identification::Verdict::kNothingMissing:
      return ExitCode::kPasses;
    case identification::Verdict::kPartlyExplained:
    case identification::Verdict::kUnexplained:
      return ExitCode::kFails;
    case identification::Verdict::kCannotTell:
      break;
  }
  return ExitCode::kUndecided;
}

std::string printed(const IdentifyRequest& request, const IdentifyInputs& inputs,
                    const IdentifyFound& found, const report::IdentificationContext& context) {
  if (identification::find_robot_output(request.as) != nullptr) {
    if (!found.refined_robot) {
      command_line::refuse(
          fmt::format("--as {}: no value of the robot was fitted by simulation; "
                      "the report says why (leave --as out)",
                      request.as));
    }
    return robot_output_text(request.as, inputs, *found.refined_robot);
  }
  if (!request.as.empty()) return output_text(request, inputs, found);
  if (request.json) return identify_json(request, inputs, found.identification, found.robot);
  std::string text = report::identification_text(found.identification, context);
  if (found.robot) text += report::simulated_text(*found.robot);
  return for_window(text);
}

void write(const IdentifyRequest& request, const IdentifyInputs& inputs,
           const IdentifyFound& found) {
  report::IdentificationContext context{
      {}, io::name_in_text(request.rig_file), inputs.rig.name, {}, {}, {}, request.select};
  context.least = least_severity(request.severity);
  for (const std::string& log : request.logs) context.log_files.push_back(io::name_in_text(log));
  for (const identification::ColumnUse& column : inputs.rig.columns) {
    context.logged.emplace_back(identification::name_of(column.quantity));
  }
  for (const auto& actuator : inputs.actuators) {
    const io::Document& document = actuator.nominal.documents.front();
    context.actuator_files.push_back(document.file + document.path);
    context.has_actuator_files.push_back(document.path.empty());
  }
  std::vector<io::FileContent> files = refined_files(inputs, found.refined);
  if (found.refined_robot) {
    std::filesystem::create_directories(inputs.refined_folder.empty() ? "."
                                                                      : inputs.refined_folder);
    files.insert(files.end(), found.refined_robot->files.begin(), found.refined_robot->files.end());
  }
  if (!files.empty()) context.refined_files = inputs.refined;
  context.is_fitted_by_simulation = found.robot && found.robot->is_fitted;
  if (found.refined.judged)
    context.as_written = report::written_sentence(found.identification, *found.refined.judged);
  if (!request.report_file.empty()) {
    files.push_back({request.report_file,
                     report::identification_html(found.identification, context, found.regions,
                                                 found.robot ? &*found.robot : nullptr)});
  }
  if (!request.outputs.empty()) {
    files.push_back({report_document(request),
                     identify_json(request, inputs, found.identification, found.robot)});
  }
  deliver(std::move(files), printed(request, inputs, found, context));
  if (request.is_old_spelling) {
    say_old_spelling(request.refined.front(), "the refined actuator",
                     "--refined " + request.refined.front());
  }
}

ExitCode run_identify(const IdentifyRequest& asked) {
  const IdentifyRequest request = with_refined(asked);
  IdentifyInputs inputs = read(request);
  begin_gains(request, inputs);
  const IdentifyFound found = compute(request, inputs);
  write(request, inputs, found);
  // An output is missing, whatever the verdict.
  if (!inputs.refined.empty() && !found.refined.refusal.empty()) return ExitCode::kUndecided;
  return exit_code_of(found.identification.verdict);
}

}  // namespace

void add_report_document(command_line::Command& command, IdentifyRequest& request,
                         const std::string& help) {
  command.add_option("-o,--output", request.outputs, help).names_a_file().one_value_each();
}

void add_residual_command(command_line::Command& identify) {
  auto request = std::make_shared<IdentifyRequest>();
  request->select = false;
  command_line::Command command =
      identify.add_command("residual", "How large is the error, and is it more than noise?");
  add_log_options(command, *request);
  add_report_document(command, *request, "Write the report as JSON to this file");
  command.example(
      "torquewright identify residual specs/log/bench_as_built.csv --rig "
      "specs/log/bench_rig.json --actuator specs/log/bench_refined.json");
  command.works([request] { return run_identify(*request); });
}

void add_identify_command(command_line::Command& program) {
  auto request = std::make_shared<IdentifyRequest>();
  command_line::Command command =
      program.add_command("identify", "Is the model true, and if not, which effect is missing?");
  add_log_options(command, *request);
  command
      .add_option(
          "--refined", request->refined,
          "Write the actuator with what was found to this file; JOINT=FILE on a serial arm; of a "
          "robot a folder gets its document and an actuator for each group of alike joints")
      .names_a_file()
      .one_value_each();
  add_report_document(command, *request,
                      "Write the report as JSON to this file. In this version, without --refined "
                      "it gets the refined actuator instead");
  command.add_option("--report", request->report_file, "Write the report with pictures, as HTML")
      .names_a_file();
  command
      .add_flag("--empirical", request->empirical,
                "Where no effect fits, report a table over the coordinate along which most is left")
      .stated_as("empirical");
  command.add_option("--only", request->only, "Effects that may be named (docs/effects.md)")
      .otherwise("any")
      .separated_by_commas()
      .one_value_each()
      .stated_as("only", 1);
  command.add_option("--without", request->without, "Effects that may not be named, as for --only")
      .otherwise("none")
      .separated_by_commas()
      .one_value_each()
      .stated_as("without", 1);
  command
      .add_option(
          "--tolerance", request->tolerance,
          "An effect that changes the prediction by less than this share of it is not named")
      .between(0.0, 1.0)
      .stated_as("tolerance");
  std::string outputs;
  for (const identification::Output* output : identification::output_library()) {
    outputs += fmt::format("{}{}: {}", outputs.empty() ? "" : "; ", output->name, output->what);
  }
  for (const identification::RobotOutput& output : identification::robot_outputs()) {
    outputs += fmt::format("; {}: {}", output.name, output.what);
  }
  add_severity_option(command, request->severity);
  command
      .add_option("--as", request->as,
                  "Print numbers for other programs in place of the report. " + outputs)
      .otherwise("the report")
      .excludes("--json");
  command.example(
      "torquewright identify specs/log/bench_as_built.csv --rig "
      "specs/log/bench_rig.json --actuator specs/log/bench_actuator.json");
  add_residual_command(command);
  add_identify_import(command);
  add_identify_simulate(command);
  add_identify_plan(command);
  command.works([request] { return run_identify(*request); });
}

}  // namespace torquewright::cli
