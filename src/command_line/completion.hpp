// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/command_line/declaration.hpp"

namespace torquewright::command_line {

/// Scripts that make a shell complete commands, options and words; files where neither is due.
std::string bash_completion(const DeclaredCommand& program);
std::string zsh_completion(const DeclaredCommand& program);
std::string fish_completion(const DeclaredCommand& program);

}  // namespace torquewright::command_line
