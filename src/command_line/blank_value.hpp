// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "src/command_line/declaration.hpp"

namespace torquewright::command_line {

/// What is said of the first option whose value is blank, or whose list has a blank place: the
/// parser passes over those, so that what follows would take another's place. None: there is none.
std::optional<std::string> blank_value(const DeclaredCommand& program,
                                       std::span<const std::string> words);

}  // namespace torquewright::command_line
