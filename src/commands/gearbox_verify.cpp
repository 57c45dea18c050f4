// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "gearbox/problem_spec.hpp"
#include "io/json_text.hpp"
#include "src/commands/gearbox_commands.hpp"
#include "src/commands/proof_check.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

ExitCode run_verify(const std::string& result_file, bool json) {
  const io::Document result = io::read_document(result_file, "gearbox_result");
  if (result.root.at("certificate").value("claims", nlohmann::json()).empty()) {
    throw io::SpecError({{result_file, "/certificate",
                          "claims nothing, must be the proof that `gearbox optimize` writes; "
                          "`gearbox evaluate` writes none"}});
  }
  const io::Document document =
      io::check_document(result.root.at("problem"), "gearbox_problem", result.file, "/problem");
  const ProofCheck check = check_proof(gearbox::read_problem(document), result.root);
  const nlohmann::ordered_json verdict{
      {"accepted", check.is_accepted}, {"undecided", check.is_undecided}, {"text", check.text}};
  print_result(json ? io::json_text(verdict) : check.text);
  if (!check.is_accepted) return ExitCode::kFails;
  return check.is_undecided ? ExitCode::kUndecided : ExitCode::kPasses;
}

}  // namespace

void add_verify_command(CLI::App& gearbox, ExitCode& result) {
  struct Options {
    std::string result_file;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      gearbox.add_subcommand("verify", "Check a result's certificate without the solver");
  command->add_option("result", options->result_file, "Document of kind gearbox_result")
      ->required();
  command->add_flag("--json", options->json, "Print the verdict as JSON");
  command->footer("Example:\n  torquewright gearbox verify specs/gearbox/d151_knee_result.json");
  command->callback(
      [options, &result] { result = run_verify(options->result_file, options->json); });
}

}  // namespace torquewright::cli
