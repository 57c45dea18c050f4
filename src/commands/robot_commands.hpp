// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "src/exit_code.hpp"

namespace torquewright::cli {

void add_import_command(CLI::App& robot, ExitCode& result);
void add_export_command(CLI::App& robot, ExitCode& result);

}  // namespace torquewright::cli
