// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// Each adds one command to `hopper`.
void add_hopper_check_command(command_line::Command& hopper);
void add_flip_command(command_line::Command& hopper);
void add_replay_command(command_line::Command& hopper);
void add_train_command(command_line::Command& hopper);
void add_calibrate_command(command_line::Command& hopper);

}  // namespace torquewright::cli
