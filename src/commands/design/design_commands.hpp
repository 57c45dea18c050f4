// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// Adds `design` to the program.
void add_design_command(command_line::Command& program);

}  // namespace torquewright::cli
