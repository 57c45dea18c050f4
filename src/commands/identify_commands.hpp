// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "src/exit_code.hpp"

namespace torquewright::cli {

/// Adds `torquewright identify LOG...` and its subcommands; when one has run, `result` is its exit
/// code.
void add_identify_command(CLI::App& app, ExitCode& result);

/// Subcommands of `torquewright identify`.
void add_residual_command(CLI::App& identify, ExitCode& result);
void add_identify_simulate(CLI::App& identify, ExitCode& result);
void add_identify_plan(CLI::App& identify, ExitCode& result);

}  // namespace torquewright::cli
