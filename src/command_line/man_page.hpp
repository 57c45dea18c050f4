// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/command_line/declaration.hpp"

namespace torquewright::command_line {

/// A page for man(1), in roff. `path` is the words that lead to the command; `version` stands at
/// the foot.
std::string man_page(const DeclaredCommand& command, const std::string& path,
                     const std::string& version);

}  // namespace torquewright::command_line
