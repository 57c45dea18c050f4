// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace torquewright::command_line {

/// What the arguments say of an option; std::monostate where nothing holds unless it is named.
using OptionValue =
    std::variant<std::monostate, bool, double, std::int64_t, std::uint64_t, std::string,
                 std::vector<std::string>, std::vector<double>, std::vector<std::int64_t>>;

/// How a result states what an option was, under its key (option_echo.hpp).
struct OptionEcho {
  std::string key;  ///< "load_window_s"; empty: no result states it.
  enum class When {
    kUnlessUsual,  ///< Where it is not what holds where it is not named.
    kAlways,
    kElsewhere  ///< The result has a place of its own for it: only a fingerprint counts it.
  } when = When::kUnlessUsual;
  int place = 0;            ///< Least first; of the same place in the order of declaration.
  bool is_negated = false;  ///< A flag that is stated as false.
};

/// An option or an argument by its place, as it was declared.
struct DeclaredOption {
  std::vector<std::string> names;  ///< -o, --output; of an argument by its place its one name.
  std::string help;
  std::string value;                  ///< NUMBER, N, TEXT, FILE; empty: a flag, which takes none.
  std::vector<std::string> choices;   ///< Empty: not only certain words.
  std::string range;                  ///< In words: "a number from 0 to 1"; empty: any.
  std::string otherwise;              ///< What holds where it is not named; empty: not said.
  std::vector<std::string> needs;     ///< Other options without which it is refused.
  std::vector<std::string> excludes;  ///< Other options with which it is refused.
  bool is_argument = false;           ///< By its place.
  bool is_required = false;
  bool is_list = false;
  bool is_repeated = false;       ///< A list of one value each time that it is named.
  bool has_commas = false;        ///< A list whose values may be separated by commas.
  bool writes_file = false;       ///< Names a file to be written; "-" is standard output.
  bool is_never_printed = false;  ///< A file for which "-" is refused.
  bool is_of_one = false;         ///< What it asks for is of one answer: no sweep takes it.
  OptionEcho echo;
  std::function<OptionValue()> value_now;  ///< What it is; empty of --help and --version.
  OptionValue usual;                       ///< What it was when it was declared.
};

/// A command, or the program itself.
struct DeclaredCommand {
  std::string name;
  std::string help;
  std::string example;  ///< A command line; may be empty.
  bool needs_command = false;
  std::deque<DeclaredOption> options;  ///< Stay where they are when others are added.
  std::list<DeclaredCommand> commands;
};

/// The command of that name, or null.
const DeclaredCommand* find_command(const DeclaredCommand& command, std::string_view name);

/// Calls with the program and every command, each with the words behind the program's name that
/// lead to it: "", "gearbox", "gearbox optimize".
void for_each_command(
    const DeclaredCommand& program,
    const std::function<void(const DeclaredCommand& command, const std::string& words)>& visit);

/// The option of that name (-o, --output), or null.
const DeclaredOption* find_option(const DeclaredCommand& command, std::string_view name);

/// The longest of its names: --output.
const std::string& longest_name(const DeclaredOption& option);

/// All that is to be said of it in a sentence: help, choices, range, default.
std::string meaning(const DeclaredOption& option);

/// "torquewright gearbox optimize [OPTIONS] problem", after the words that lead to the command.
std::string usage(const DeclaredCommand& command, const std::string& path);

}  // namespace torquewright::command_line
