// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/completion.hpp"

#include <memory>
#include <string>

#include "io/files/atomic_file.hpp"
#include "src/commands/shared/help_commands.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct CompletionOptions {
  std::string shell;
  std::string output_file;
};

std::string script_for(const std::string& shell, const command_line::DeclaredCommand& program) {
  if (shell == "zsh") return command_line::zsh_completion(program);
  if (shell == "fish") return command_line::fish_completion(program);
  return command_line::bash_completion(program);
}

ExitCode run_completion(const command_line::DeclaredCommand& program,
                        const CompletionOptions& options) {
  check_written(named({options.output_file}), {});
  deliver_result(script_for(options.shell, program), options.output_file);
  return ExitCode::kPasses;
}

}  // namespace

void add_completion_command(command_line::Command& program) {
  auto options = std::make_shared<CompletionOptions>();
  command_line::Command command = program.add_command(
      "completion",
      "Print a script by which a shell completes: source <(torquewright completion bash)");
  command.add_option("shell", options->shell, "The shell that is to complete")
      .required()
      .one_of({"bash", "zsh", "fish"});
  command.add_option("-o,--output", options->output_file, "Write the script to this file")
      .otherwise("-, standard output")
      .names_a_file();
  command.example("torquewright completion bash");
  command.works(
      [options, &declared = program.declared()] { return run_completion(declared, *options); });
}

}  // namespace torquewright::cli
