// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "src/command_line/declaration.hpp"

namespace torquewright::command_line {

/// What is wrong with the first list between whose commas nothing stands: the members behind it
/// would move up, 44,,32 be read as 44,32. Empty where there is none. `words` are the arguments of
/// the program.
std::optional<std::string> empty_member(const DeclaredCommand& program,
                                        std::span<const std::string> words);

}  // namespace torquewright::command_line
