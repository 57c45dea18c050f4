// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "src/exit_code.hpp"

namespace torquewright::cli {

/// Each adds one command to `hopper`; its verdict goes to `result`.
void add_hopper_check_command(CLI::App& hopper, ExitCode& result);
void add_calibrate_command(CLI::App& hopper, ExitCode& result);

}  // namespace torquewright::cli
