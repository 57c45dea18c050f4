// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/command_line/command_line.hpp"
#include "src/options/hopper_flip_request.hpp"

namespace torquewright::cli {

/// Adds everything that `hopper flip` takes: its own options and those of other commands too.
void add_hopper_flip_options(command_line::Command& command, HopperFlipRequest& request);

}  // namespace torquewright::cli
