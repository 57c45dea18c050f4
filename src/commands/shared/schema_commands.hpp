// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// Each adds one command to the program.
void add_init_command(command_line::Command& program);
void add_schema_command(command_line::Command& program);

}  // namespace torquewright::cli
