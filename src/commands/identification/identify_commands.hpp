// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// Adds `identify LOG...` and its commands.
void add_identify_command(command_line::Command& program);

/// Each adds one command to `identify`.
void add_residual_command(command_line::Command& identify);
void add_identify_simulate(command_line::Command& identify);
void add_identify_import(command_line::Command& identify);
void add_identify_plan(command_line::Command& identify);

}  // namespace torquewright::cli
