// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "actuator/trajectory/trajectory_reader.hpp"
#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// The options by which a user says which part of a trajectory counts.
struct WindowOptions {
  std::optional<double> from_s;
  std::optional<double> until_s;
};

/// Adds --from and --until.
std::vector<command_line::Option> add_window_options(command_line::Command& command,
                                                     WindowOptions& options);

/// Throws io::SpecError where it ends before it begins.
actuator::Window window_of(const WindowOptions& options);

}  // namespace torquewright::cli
