// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/command_line/declaration.hpp"

namespace torquewright::command_line {

/// What --help prints. `path` is the words that lead to the command: "torquewright gearbox".
std::string help_text(const DeclaredCommand& command, const std::string& path);

}  // namespace torquewright::command_line
