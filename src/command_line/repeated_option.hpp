// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "src/command_line/declaration.hpp"

namespace torquewright::command_line {

/// What is said of the first option of one value that is named twice, under one of its names or
/// two. None: there is none.
std::optional<std::string> repeated_option(const DeclaredCommand& program,
                                           std::span<const std::string> words);

}  // namespace torquewright::command_line
