// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/exit_code.hpp"

// CLI11's, which only command_line.cpp includes: its headers cost seconds in every file.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace torquewright::command_line {

/// An option or an argument that was declared; a handle, to say more of it.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required();
  /// A value each time it is named; else a list takes all words up to the next option.
  Option one_value_each();
  Option separated_by_commas();
  /// A list of exactly so many values.
  Option takes(int values);
  Option shows_default();  ///< In the help.

  /// Both ends included.
  Option between(double least, double greatest);
  Option integer_between(std::int64_t least, std::int64_t greatest);
  Option positive();
  Option one_of(const std::vector<std::string>& words);
  Option existing_file();
  /// A file to be written. An unset variable of a script leaves "": nothing would be written, and
  /// nobody would know.
  Option names_a_file();

  /// Other options by their names, declared before: not with this one, or only with it.
  Option excludes(const std::string& other);
  Option needs(const std::string& other);

 private:
  CLI::Option* option_;
};

/// Runs what was asked for. Called after all arguments were read.
using Work = std::function<cli::ExitCode()>;

/// A command that was declared, or the program itself; a handle, to declare its options, its
/// commands and its work.
class Command {
 public:
  Command(CLI::App& app, std::vector<Work>& named) : app_(&app), named_(&named) {}

  /// The arguments fill `value`, which must live until they are read; what stands in it before is
  /// the default. A number must be finite. Names are "--name", "-n,--name", or "name" for an
  /// argument by its place.
  Option add_option(const std::string& names, std::string& value, const std::string& help);
  Option add_option(const std::string& names, double& value, const std::string& help);
  Option add_option(const std::string& names, std::optional<double>& value,
                    const std::string& help);
  Option add_option(const std::string& names, int& value, const std::string& help);
  Option add_option(const std::string& names, std::int64_t& value, const std::string& help);
  Option add_option(const std::string& names, std::uint64_t& value, const std::string& help);
  Option add_option(const std::string& names, std::vector<std::string>& values,
                    const std::string& help);
  Option add_option(const std::string& names, std::vector<double>& values, const std::string& help);
  Option add_option(const std::string& names, std::vector<std::int64_t>& values,
                    const std::string& help);
  /// "!--name" makes the value false.
  Option add_flag(const std::string& names, bool& value, const std::string& help);

  Command add_command(const std::string& name, const std::string& help);
  /// One of its commands must be named.
  void require_command();
  /// The last lines of the help.
  void example(const std::string& line);
  /// What it does. Where one of its commands is named, that one works in its place.
  void works(Work work);

 private:
  CLI::App* app_;
  std::vector<Work>* named_;  ///< Of the commands that the arguments name.
};

/// A program's command line: declared first, then run.
class Program {
 public:
  /// An empty version: there is no --version.
  Program(const std::string& name, const std::string& help, const std::string& version = "");
  ~Program();

  Command& top() { return top_; }

  /// Reads the arguments and runs the command that they name; --help and --version print and pass.
  /// Throws io::SpecError where arguments are not understood, and whatever the work throws.
  cli::ExitCode run(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
  std::vector<Work> named_;
  Command top_;
};

/// Throws io::SpecError: the command line as a whole.
[[noreturn]] void refuse(const std::string& why);

}  // namespace torquewright::command_line
