// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// Each adds one command to the program that tells of all its commands.
void add_help_command(command_line::Command& program);
void add_man_command(command_line::Command& program);
void add_completion_command(command_line::Command& program);

}  // namespace torquewright::cli
