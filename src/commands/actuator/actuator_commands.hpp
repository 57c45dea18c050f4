// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// Each adds one command to `actuator`.
void add_find_command(command_line::Command& actuator);
void add_lint_command(command_line::Command& actuator);
void add_mor_command(command_line::Command& actuator);
void add_check_command(command_line::Command& actuator);

}  // namespace torquewright::cli
