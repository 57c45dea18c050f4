// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/command_line/declaration.hpp"
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
  Option(CLI::Option& option, DeclaredOption& declared) : option_(&option), declared_(&declared) {}

  Option required();
  /// Required by what the command does, which looks itself: where another command may be named.
  Option needed_by_its_work();
  /// A value each time it is named; else a list takes all words up to the next option.
  Option one_value_each();
  Option separated_by_commas();
  /// A list of exactly so many values.
  Option takes(int values);
  /// States what holds where it is not named, in words, where no value stands for it: "the
  /// document's".
  Option otherwise(const std::string& what);

  /// Requires a number between the two, both ends included.
  Option between(double least, double greatest);
  Option integer_between(std::int64_t least, std::int64_t greatest);
  Option positive();
  Option one_of(const std::vector<std::string>& words);
  /// States the words that help and completion name; the work refuses others.
  Option offers(const std::vector<std::string>& words);
  Option existing_file();
  /// A file to be written. An unset variable of a script leaves "": nothing would be written, and
  /// nobody would know.
  Option names_a_file();
  /// Such a file for which "-", standard output, is refused by name.
  Option not_standard_output();

  /// Other options by their names, declared before: not with this one, or only with it.
  Option excludes(const std::string& other);
  Option needs(const std::string& other);

  /// Its key under "options" of a result, which states it where it is not the usual. `place`:
  /// results state the least first, and options of one place in the order of declaration.
  Option stated_as(const std::string& key, int place = 0);
  /// Its key under "options", which is stated as false: of a flag that denies what the key says.
  Option stated_as_not(const std::string& key, int place = 0);
  /// Its key under "options", which is stated whatever the option is.
  Option always_stated_as(const std::string& key, int place = 0);
  /// Its key where fingerprints count it, of an option that the result has in a place of its own.
  Option stated_elsewhere_as(const std::string& key, int place = 0);
  /// Asks for what shows one answer: a sweep, which has several, refuses it by name.
  Option of_one_answer();

 private:
  Option echoed(const OptionEcho& echo);
  /// The value at declaration is no default where it lies outside what is allowed.
  void drop_default_unless(bool is_allowed);
  void says_more_than_its_kind();

  CLI::Option* option_;
  DeclaredOption* declared_;
  bool is_default_said_ = false;  ///< By otherwise().
};

/// Runs what was asked for. Called after all arguments were read.
using Work = std::function<cli::ExitCode()>;

/// A command that was declared, or the program itself; a handle, to declare its options, its
/// commands and its work.
class Command {
 public:
  Command(CLI::App& app, DeclaredCommand& declared, std::vector<Work>& named)
      : app_(&app), declared_(&declared), named_(&named) {}

  /// The arguments fill `value`, which must live until they are read; what stands in it before is
  /// the default, and in the help unless it lies outside what is allowed. A number must be finite.
  /// Names are "--name", "-n,--name", or "name" for an argument by its place.
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
  /// Sets what the command does. Where one of its commands is named, that one works in its place.
  void works(Work work);

  /// All that was declared so far; it stays where it is.
  const DeclaredCommand& declared() const { return *declared_; }

 private:
  /// An option whose arguments fill `value`; `kind` is the word for one of them in the help.
  template <typename Value>
  Option add(CLI::Option& option, const std::string& names, const Value& value,
             const std::string& kind, const std::string& help, bool is_list = false);

  CLI::App* app_;
  DeclaredCommand* declared_;
  std::vector<Work>* named_;  ///< Of the commands that the arguments name.
};

/// A program's command line: declared first, then run.
class Program {
 public:
  /// An empty version: there is no --version.
  Program(const std::string& name, const std::string& help, const std::string& version = "");
  ~Program();

  Command& top() { return top_; }

  /// Reads the arguments and runs the command that they name; --help and --version print and pass,
  /// and so does a command that only leads to others where none of them is named: with its help.
  /// Throws io::SpecError where arguments are not understood, and whatever the work throws.
  cli::ExitCode run(int argc, const char* const* argv);

 private:
  bool is_answered(const std::vector<std::string>& words, const std::exception& error) const;
  [[noreturn]] void refuse_words(const std::vector<std::string>& words,
                                 const std::string& why) const;

  std::unique_ptr<CLI::App> app_;
  DeclaredCommand declared_;
  std::string version_;
  std::vector<Work> named_;
  Command top_;
};

/// Throws io::SpecError: the command line as a whole.
[[noreturn]] void refuse(const std::string& why);

}  // namespace torquewright::command_line
