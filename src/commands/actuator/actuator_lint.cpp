// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actuator/lint/examination.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "actuator/winding/winding_estimate.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/actuator/actuator_commands.hpp"
#include "src/commands/actuator/actuator_lint_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/options/output_files.hpp"
#include "src/options/severity_option.hpp"
#include "src/report/actuator/lint_text.hpp"
#include "src/report/actuator/winding_text.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct LintOptions {
  std::vector<std::string> actuator_files;
  std::optional<double> torque_constant_Nm_A;  ///< Of the winding behind a curve, as the next.
  std::optional<double> resistance_ohm;
  std::optional<double> voltage_V;
  std::optional<double> current_A;
  SeverityOption severity;
  std::string output_file;
  bool json = false;
};

struct LintInputs {
  std::vector<actuator::Actuator> actuators;
  std::vector<io::Document> documents;
};

actuator::KnownWinding known_winding(const LintOptions& options, const LintInputs& inputs) {
  actuator::KnownWinding known{options.torque_constant_Nm_A, options.resistance_ohm,
                               options.voltage_V, options.current_A};
  if (!known.voltage_V) known.voltage_V = inputs.actuators.front().envelope->voltage_V;
  return known;
}

bool asks_for_winding(const LintOptions& options) {
  return options.torque_constant_Nm_A || options.resistance_ohm || options.voltage_V ||
         options.current_A;
}

/// Two of the four at least, and one curve.
void require_winding(const LintOptions& options, const LintInputs& inputs) {
  if (!asks_for_winding(options)) return;
  if (inputs.actuators.size() != 1 || !inputs.actuators.front().envelope) {
    io::refuse("--torque-constant, --resistance, --voltage, --current",
               "are of the winding behind one curve: one document with /envelope");
  }
  const actuator::KnownWinding known = known_winding(options, inputs);
  const int count = int{known.torque_constant_Nm_A.has_value()} +
                    int{known.resistance_ohm.has_value()} + int{known.voltage_V.has_value()} +
                    int{known.current_A.has_value()};
  if (count >= 2) return;
  io::refuse("--torque-constant, --resistance, --voltage, --current",
             "two of the four are needed; /envelope/voltage_V counts as the voltage");
}

std::optional<actuator::WindingEstimate> estimate_of(const LintOptions& options,
                                                     const LintInputs& inputs) {
  if (!asks_for_winding(options)) return std::nullopt;
  return actuator::winding_estimate(inputs.actuators.front(), known_winding(options, inputs));
}

LintInputs read(const LintOptions& options) {
  LintInputs inputs;
  for (const std::string& file : options.actuator_files) {
    actuator::ReadActuator read = actuator::read_actuator(file);
    inputs.actuators.push_back(std::move(read.actuator));
    for (io::Document& document : read.documents) inputs.documents.push_back(std::move(document));
  }
  require_winding(options, inputs);
  check_written(named({options.output_file}), {});
  return inputs;
}

void write(const LintOptions& options, const LintInputs& inputs,
           const actuator::lint::Report& report,
           const std::optional<actuator::WindingEstimate>& winding) {
  std::string text = report::lint_text(report, least_severity(options.severity));
  if (winding) text += report::winding_text(*winding);
  deliver_report(
      {lint_document(report, winding, inputs.documents), text, report::lint_answer(report)},
      options.output_file, options.json);
}

ExitCode run_lint(const LintOptions& options) {
  const LintInputs inputs = read(options);
  const actuator::lint::Report report = actuator::lint::examine_all(inputs.actuators);
  const std::optional<actuator::WindingEstimate> winding = estimate_of(options, inputs);
  write(options, inputs, report, winding);
  const bool contradicts = winding && !winding->contradiction.empty();
  return contradicts || actuator::lint::has_contradiction(report) ? ExitCode::kFails
                                                                  : ExitCode::kPasses;
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
  command
      .add_option(
          "--torque-constant", options->torque_constant_Nm_A,
          "Of the winding behind a curve (/envelope), in Nm/A of one equivalent winding: any "
          "two of this and the next three estimate the others")
      .otherwise("not known")
      .between(1e-6, 1e3);
  command.add_option("--resistance", options->resistance_ohm, "Between its terminals, in ohm")
      .otherwise("not known")
      .between(1e-6, 1e4);
  command.add_option("--voltage", options->voltage_V, "Voltage of its supply, in V")
      .otherwise("/envelope/voltage_V, else not known")
      .between(0.1, 2000.0);
  command.add_option("--current", options->current_A, "At its peak torque, in A")
      .otherwise("not known")
      .between(1e-3, 1e5);
  add_severity_option(command, options->severity);
  command.add_option("-o,--output", options->output_file, "Write the report as JSON to this file")
      .names_a_file();
  command.add_flag("--json", options->json, "Print the same as JSON");
  command.example("torquewright actuator lint specs/actuator/d151_knee.json");
  command.works([options] { return run_lint(*options); });
}

}  // namespace torquewright::cli
