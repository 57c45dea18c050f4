// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "actuator/lint/report_spec.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "src/commands/actuator_commands.hpp"
#include "src/report/lint_text.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct LintOptions {
  std::vector<std::string> actuator_files;
  bool json = false;
};

std::string json_text(const actuator::lint::Report& report,
                      const std::vector<io::Document>& documents) {
  nlohmann::ordered_json document = actuator::lint::report_json(report);
  document["tool"] = io::tool_provenance();
  document["inputs"] = io::input_provenance(documents);
  return io::json_text(document);
}

ExitCode run_lint(const LintOptions& options) {
  std::vector<actuator::Actuator> actuators;
  std::vector<io::Document> documents;
  for (const std::string& file : options.actuator_files) {
    actuator::ReadActuator read = actuator::read_actuator(file);
    actuators.push_back(std::move(read.actuator));
    for (io::Document& document : read.documents) documents.push_back(std::move(document));
  }
  const actuator::lint::Report report = actuator::lint::examine_all(actuators);
  const std::string text = options.json ? json_text(report, documents) : report::lint_text(report);
  print_result(text);
  return actuator::lint::has_contradiction(report) ? ExitCode::kFails : ExitCode::kPasses;
}

}  // namespace

void add_lint_command(CLI::App& actuator, ExitCode& result) {
  auto options = std::make_shared<LintOptions>();
  CLI::App* command = actuator.add_subcommand("lint", "Contradictions between stated numbers");
  command
      ->add_option("actuator", options->actuator_files,
                   "Documents of kind actuator; several are compared with one another too")
      ->required();
  command->add_flag("--json", options->json, "The same as JSON");
  command->footer("Example:\n  torquewright actuator lint specs/actuator/d151_knee.json");
  command->callback([options, &result] { result = run_lint(*options); });
}

}  // namespace torquewright::cli
