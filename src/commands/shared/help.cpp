// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/documents/provenance.hpp"
#include "io/files/atomic_file.hpp"
#include "src/command_line/help_text.hpp"
#include "src/command_line/man_page.hpp"
#include "src/command_line/misspelling.hpp"
#include "src/commands/shared/help_commands.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

using command_line::DeclaredCommand;
using command_line::Reached;

struct HelpOptions {
  std::vector<std::string> words;  ///< Of the command.
  std::string output_file;
  std::string folder;  ///< For a page of every command; empty: of one.
};

Reached named_command(const DeclaredCommand& program, const std::vector<std::string>& words) {
  const Reached reached = command_line::reached_by(program, words);
  if (reached.rest < words.size()) {
    command_line::refuse(command_line::unknown_command(program, reached, words[reached.rest]));
  }
  return reached;
}

ExitCode run_help(const DeclaredCommand& program, const HelpOptions& options) {
  const Reached reached = named_command(program, options.words);
  print_result(command_line::help_text(*reached.command, reached.path));
  return ExitCode::kPasses;
}

/// Where man looks for it: torquewright-gearbox-optimize.1.
io::FileContent page_file(const DeclaredCommand& command, const std::string& path,
                          const std::filesystem::path& folder) {
  std::string name = path + ".1";
  std::replace(name.begin(), name.end(), ' ', '-');
  return {folder / name, command_line::man_page(command, path, std::string(io::tool_version()))};
}

ExitCode write_every_page(const DeclaredCommand& program, const std::filesystem::path& folder) {
  std::vector<io::FileContent> pages;
  command_line::for_each_command(
      program, [&](const DeclaredCommand& command, const std::string& words) {
        const std::string path = program.name + (words.empty() ? "" : " " + words);
        pages.push_back(page_file(command, path, folder));
      });
  io::write_whole_files(pages);
  return ExitCode::kPasses;
}

ExitCode run_man(const DeclaredCommand& program, const HelpOptions& options) {
  if (!options.folder.empty()) return write_every_page(program, options.folder);
  const Reached reached = named_command(program, options.words);
  check_written(named({options.output_file}), {});
  deliver_result(
      command_line::man_page(*reached.command, reached.path, std::string(io::tool_version())),
      options.output_file);
  return ExitCode::kPasses;
}

}  // namespace

void add_help_command(command_line::Command& program) {
  auto options = std::make_shared<HelpOptions>();
  command_line::Command command = program.add_command("help", "Say what a command does");
  command.add_option("command", options->words, "Words of the command, such as gearbox optimize");
  command.example("torquewright help gearbox optimize");
  command.works([options, &declared = program.declared()] { return run_help(declared, *options); });
}

void add_man_command(command_line::Command& program) {
  auto options = std::make_shared<HelpOptions>();
  command_line::Command command = program.add_command(
      "man", "Print a command's help as a page for man: torquewright man | man -l -");
  command.add_option("command", options->words, "Words of the command, such as gearbox optimize");
  command.add_option("-o,--output", options->output_file, "Write the page to this file")
      .otherwise("-, standard output")
      .names_a_file();
  command
      .add_option("--all", options->folder,
                  "Write the pages of all commands into this folder, which must exist")
      .names_a_file()
      .excludes("command")
      .excludes("--output");
  command.example("torquewright man gearbox optimize");
  command.works([options, &declared = program.declared()] { return run_man(declared, *options); });
}

}  // namespace torquewright::cli
