// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "src/exit_code.hpp"

namespace torquewright::cli {

/// Each adds one subcommand of `torquewright actuator`; when it has run, `result` is its exit code.
void add_lint_command(CLI::App& actuator, ExitCode& result);
void add_mor_command(CLI::App& actuator, ExitCode& result);
void add_check_command(CLI::App& actuator, ExitCode& result);

}  // namespace torquewright::cli
