// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/options/operating_options.hpp"
#include "src/options/severity_option.hpp"
#include "src/options/window_options.hpp"

namespace torquewright::cli {

/// The options of `actuator check`, as given.
struct CheckOptions {
  std::string trajectory_file;
  std::vector<std::string> joints;   ///< NAME=FILE
  std::vector<std::string> columns;  ///< NAME=JOINT.QUANTITY[:unit][*factor]
  std::vector<std::string> columns_files;
  std::vector<std::string> jacobian_files;
  WindowOptions window;
  OperatingOptions operating;
  bool torque_includes_inertia = false;
  bool torque_excludes_inertia = false;
  std::size_t runs = 1;
  double pause_s = 0.0;
  /// Its command's options, of which results state some (command_line/option_echo.hpp).
  const command_line::DeclaredCommand* declared = nullptr;
  SeverityOption severity;
  std::string plot_file;
  std::string output_file;
  bool watch = false;
  bool json = false;
};

/// Adds everything that `actuator check` takes.
void add_check_options(command_line::Command& command, CheckOptions& options);

}  // namespace torquewright::cli
