// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "actuator/lint/report_spec.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "src/commands/actuator/actuator_commands.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/options/output_files.hpp"
#include "src/report/actuator/lint_text.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct LintOptions {
  std::vector<std::string> actuator_files;
  std::string output_file;
  bool json = false;
};

struct LintInputs {
  std::vector<actuator::Actuator> actuators;
  std::vector<io::Document> documents;
};

LintInputs read(const LintOptions& options) {
  LintInputs inputs;
  for (const std::string& file : options.actuator_files) {
    actuator::ReadActuator read = actuator::read_actuator(file);
    inputs.actuators.push_back(std::move(read.actuator));
    for (io::Document& document : read.documents) inputs.documents.push_back(std::move(document));
  }
  check_written(named({options.output_file}), {});
  return inputs;
}

void write(const LintOptions& options, const LintInputs& inputs,
           const actuator::lint::Report& report) {
  deliver_report({result_text(actuator::lint::report_json(report), inputs.documents),
                  report::lint_text(report)},
                 options.output_file, options.json);
}

ExitCode run_lint(const LintOptions& options) {
  const LintInputs inputs = read(options);
  const actuator::lint::Report report = actuator::lint::examine_all(inputs.actuators);
  write(options, inputs, report);
  return actuator::lint::has_contradiction(report) ? ExitCode::kFails : ExitCode::kPasses;
}

}  // namespace

void add_lint_command(command_line::Command& actuator) {
  auto options = std::make_shared<LintOptions>();
  command_line::Command command =
      actuator.add_command("lint", "Find contradictions between stated numbers");
  command
      .add_option("actuator", options->actuator_files,
                  "Documents of kind actuator; several are compared with one another too")
      .required();
  command.add_option("-o,--output", options->output_file, "Write the report as JSON to this file")
      .names_a_file();
  command.add_flag("--json", options->json, "Print the same as JSON");
  command.example("torquewright actuator lint specs/actuator/d151_knee.json");
  command.works([options] { return run_lint(*options); });
}

}  // namespace torquewright::cli
