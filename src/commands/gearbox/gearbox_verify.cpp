// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <utility>

#include "gearbox/problem_spec.hpp"
#include "gearbox/verification/verification_json.hpp"
#include "io/documents/document.hpp"
#include "src/commands/gearbox/gearbox_commands.hpp"
#include "src/commands/gearbox/gearbox_result_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/interrupt.hpp"
#include "src/options/output_files.hpp"
#include "src/report/gearbox/proof_json.hpp"
#include "src/report/gearbox/proof_text.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct VerifyOptions {
  std::string result_file;
  std::string output_file;
  bool json = false;
};

/// A result holds the problem that it answers.
struct VerifyInputs {
  io::Document result;
  gearbox::Problem problem;
};

VerifyInputs read(const VerifyOptions& options) {
  io::Document result = read_result(options.result_file);
  const io::Document document =
      io::check_document(result.root.at("problem"), "gearbox_problem", result.file, "/problem");
  gearbox::Problem problem = document.root.contains("synthesis")
                                 ? gearbox::read_open_problem(document)
                                 : gearbox::read_problem(document);
  check_written(named({options.output_file}), {});
  return {std::move(result), std::move(problem)};
}

void write(const VerifyOptions& options, const VerifyInputs& inputs,
           const gearbox::Verification& found) {
  deliver_report(
      {result_text(report::proof_json(found), {&inputs.result, 1}), report::proof_text(found)},
      options.output_file, options.json);
}

ExitCode run_verify(const VerifyOptions& options) {
  const VerifyInputs inputs = read(options);
  catch_interrupt();
  const gearbox::Verification found =
      gearbox::verify(inputs.problem, inputs.result.root, is_interrupted);
  write(options, inputs, found);
  if (found.is_ended) return ExitCode::kUndecided;
  if (!found.is_accepted) return ExitCode::kFails;
  return found.is_undecided ? ExitCode::kUndecided : ExitCode::kPasses;
}

}  // namespace

void add_verify_command(command_line::Command& gearbox) {
  auto options = std::make_shared<VerifyOptions>();
  command_line::Command command =
      gearbox.add_command("verify", "Check the proof in a result again, without the search");
  command.add_option("result", options->result_file, "Document of kind gearbox_result").required();
  command.add_option("-o,--output", options->output_file, "Write the verdict as JSON to this file")
      .names_a_file();
  command.add_flag("--json", options->json, "Print the verdict as JSON");
  command.example("torquewright gearbox verify specs/gearbox/d151_knee_result.json");
  command.works([options] { return run_verify(*options); });
}

}  // namespace torquewright::cli
