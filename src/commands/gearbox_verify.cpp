// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <utility>

#include "gearbox/problem_spec.hpp"
#include "io/document.hpp"
#include "io/file_bytes.hpp"
#include "io/json_reader.hpp"
#include "src/commands/gearbox_commands.hpp"
#include "src/commands/proof_check.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

/// A result of `evaluate` has the same kind, but claims nothing that could be proved.
void refuse_evaluation(const nlohmann::json& result, const std::string& file) {
  if (!result.is_object() || !result.contains("rank")) return;
  throw io::SpecError({{file, "/certificate",
                        "holds no claims: this is what `gearbox evaluate` says of one design; "
                        "`gearbox verify` checks the proof in a result of `gearbox optimize`"}});
}

io::Document read_result(const std::string& file) {
  io::JsonText text = io::read_json_text(io::read_file_bytes(file), file);
  if (!text.faults.empty()) throw io::SpecError(std::move(text.faults));
  refuse_evaluation(text.root, file);
  return io::check_document(std::move(text.root), "gearbox_result", file, "");
}

struct VerifyOptions {
  std::string result_file;
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
  return {std::move(result), gearbox::read_problem(document)};
}

void write(const VerifyOptions& options, const ProofCheck& check) {
  print_result(options.json ? io::json_text(check.json) : check.text);
}

ExitCode run_verify(const VerifyOptions& options) {
  const VerifyInputs inputs = read(options);
  const ProofCheck check = check_proof(inputs.problem, inputs.result.root);
  write(options, check);
  if (!check.is_accepted) return ExitCode::kFails;
  return check.is_undecided ? ExitCode::kUndecided : ExitCode::kPasses;
}

}  // namespace

void add_verify_command(command_line::Command& gearbox) {
  auto options = std::make_shared<VerifyOptions>();
  command_line::Command command =
      gearbox.add_command("verify", "Check a result's certificate without the solver");
  command.add_option("result", options->result_file, "Document of kind gearbox_result").required();
  command.add_flag("--json", options->json, "Print the verdict as JSON");
  command.example("torquewright gearbox verify specs/gearbox/d151_knee_result.json");
  command.works([options] { return run_verify(*options); });
}

}  // namespace torquewright::cli
