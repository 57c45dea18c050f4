// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// Each adds one command to `robot`.
void add_attach_command(command_line::Command& robot);
void add_import_command(command_line::Command& robot);
void add_patch_command(command_line::Command& robot);
void add_export_command(command_line::Command& robot);
void add_workspace_command(command_line::Command& robot);

}  // namespace torquewright::cli
