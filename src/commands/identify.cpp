// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>

#include "identification/report_spec.hpp"
#include "io/atomic_file.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "src/commands/identify_commands.hpp"
#include "src/commands/refined_actuators.hpp"
#include "src/options/identify_request.hpp"
#include "src/report/gnuplot.hpp"
#include "src/report/identification_html.hpp"
#include "src/report/identification_text.hpp"
#include "src/report/progress_line.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

using identification::Identification;
using identification::Verdict;
using nlohmann::ordered_json;

std::string json_text(const IdentifyRequest& request, const IdentifyInputs& inputs,
                      const Identification& found) {
  ordered_json document = identification::identification_report_json(found);
  document["options"] = ordered_json::object();
  if (!request.select) document["options"]["select"] = false;
  if (request.empirical) document["options"]["empirical"] = true;
  document["tool"] = io::tool_provenance();
  std::vector<io::Document> documents;
  for (const auto& file : found.files) documents.push_back({file.path, "", {}, file.sha256});
  documents.push_back(inputs.rig_document);
  for (const auto& actuator : inputs.actuators) {
    documents.insert(documents.end(), actuator.nominal.documents.begin(),
                     actuator.nominal.documents.end());
  }
  document["inputs"] = io::input_provenance(documents);
  return io::json_text(document);
}

Identification run_identification(const IdentifyRequest& request, const IdentifyInputs& inputs) {
  report::ProgressLine progress;
  identification::IdentifyOptions options;
  options.select = request.select;
  options.empirical = request.empirical;
  options.progress = [&progress](const std::string& what, double share) {
    progress.show(fmt::format("{}: {:.0f} %", what, 100.0 * share));
  };
  return identification::identify({request.logs.begin(), request.logs.end()}, inputs.rig,
                                  inputs.actuators, options);
}

ExitCode exit_code_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kExplained:
    case Verdict::kNothingMissing:
      return ExitCode::kPasses;
    case Verdict::kPartlyExplained:
    case Verdict::kUnexplained:
      return ExitCode::kFails;
    case Verdict::kCannotTell:
      break;
  }
  return ExitCode::kUndecided;
}

ExitCode run_identify(const IdentifyRequest& request) {
  require_log_options(request);
  const IdentifyInputs inputs = read_inputs(request);
  if (!request.report_file.empty()) report::require_gnuplot("--report");  // refuse early
  const Identification found = run_identification(request, inputs);
  const std::vector<RefinedActuator> refined = refined_actuators(inputs, found);
  report::IdentificationContext context{
      request.logs, request.rig_file, inputs.rig.name, request.actuators, {}, request.select};
  std::vector<io::FileContent> files = refined_files(inputs, refined);
  for (const io::FileContent& file : files) context.refined_files.push_back(file.file.string());
  if (!request.report_file.empty()) {
    files.push_back({request.report_file, report::identification_html(
                                              found, context, region_sections(inputs, refined))});
  }
  io::write_whole_files(files);
  print_result(request.json ? json_text(request, inputs, found)
                            : report::identification_text(found, context));
  return exit_code_of(found.verdict);
}

}  // namespace

void add_residual_command(CLI::App& identify, ExitCode& result) {
  auto request = std::make_shared<IdentifyRequest>();
  request->select = false;
  CLI::App* command =
      identify.add_subcommand("residual", "How large is the error, and is it more than noise?");
  add_log_options(*command, *request);
  command->footer(
      "Example:\n  torquewright identify residual specs/log/bench_as_built.csv --rig "
      "specs/log/bench_rig.json --actuator specs/log/bench_refined.json");
  command->callback([request, &result] { result = run_identify(*request); });
}

void add_identify_command(CLI::App& app, ExitCode& result) {
  auto request = std::make_shared<IdentifyRequest>();
  CLI::App* command =
      app.add_subcommand("identify", "Is the model true, and if not, which effect is missing?");
  add_log_options(*command, *request);
  command
      ->add_option(
          "-o,--output", request->outputs,
          "Write the actuator with what was found to this file; JOINT=FILE on a serial arm")
      ->allow_extra_args(false);
  command->add_option("--report", request->report_file, "Write the report with pictures, as HTML");
  command->add_flag("--empirical", request->empirical,
                    "Where no effect fits, a table over the coordinate along which most is left");
  command->footer(
      "Example:\n  torquewright identify specs/log/bench_as_built.csv --rig "
      "specs/log/bench_rig.json --actuator specs/log/bench_actuator.json");
  add_residual_command(*command, result);
  add_identify_simulate(*command, result);
  add_identify_plan(*command, result);
  command->callback([command, request, &result] {
    if (command->get_subcommands().empty()) result = run_identify(*request);
  });
}

}  // namespace torquewright::cli
