// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// Each adds one command to `gearbox`.
void add_optimize_command(command_line::Command& gearbox);
void add_evaluate_command(command_line::Command& gearbox);
void add_verify_command(command_line::Command& gearbox);
void add_strength_command(command_line::Command& gearbox);
void add_pareto_command(command_line::Command& gearbox);
void add_drawing_command(command_line::Command& gearbox);
void add_tolerances_command(command_line::Command& gearbox);

}  // namespace torquewright::cli
