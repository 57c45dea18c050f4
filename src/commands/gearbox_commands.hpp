// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "src/exit_code.hpp"

namespace torquewright::cli {

/// Each adds one subcommand of `torquewright gearbox`; when it has run, `result` is its exit code.
void add_optimize_command(CLI::App& gearbox, ExitCode& result);
void add_evaluate_command(CLI::App& gearbox, ExitCode& result);
void add_verify_command(CLI::App& gearbox, ExitCode& result);
void add_strength_command(CLI::App& gearbox, ExitCode& result);

}  // namespace torquewright::cli
