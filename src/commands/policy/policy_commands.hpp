// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// Each adds one command to `policy`.
void add_policy_export_command(command_line::Command& policy);
void add_policy_import_command(command_line::Command& policy);

}  // namespace torquewright::cli
