// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "src/command_line/declaration.hpp"

namespace torquewright::command_line {

/// Whether a word is an option's name: not "-3" and not "-", which are values.
bool is_option(const std::string& word);

/// The first word that names no command or no option, and what may have been meant; empty where
/// every name is known. `words` are the arguments of the program.
std::optional<std::string> misspelling(const DeclaredCommand& program,
                                       std::span<const std::string> words);

/// A command, and the words that lead to it.
struct Reached {
  const DeclaredCommand* command;
  std::string path;
  std::size_t rest;  ///< Index of the first word that is not part of its name.
};

/// The command that the words lead to, as far as they do, options left aside.
Reached reached_by(const DeclaredCommand& program, std::span<const std::string> words);

/// What is wrong with a word in the place of a command.
std::string unknown_command(const DeclaredCommand& program, const Reached& where,
                            const std::string& word);

}  // namespace torquewright::command_line
