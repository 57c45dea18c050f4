// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "src/options/output_files.hpp"

namespace torquewright::cli {

/// What `gearbox optimize` is asked.
struct OptimizeRequest {
  std::string problem_file;
  OutputFiles outputs;
  /// Its command's options, of which results state some (command_line/option_echo.hpp).
  const command_line::DeclaredCommand* declared = nullptr;
  std::size_t top = 1;
  std::string relaxation = "auto";
  std::int64_t max_nodes = 0;  ///< 0: as many as it takes.
  double time_limit_s = 0.0;   ///< 0: as long as it takes.
  bool verify = false;
  bool all = false;  ///< Tables, constraints and proof, not one screen.
  bool json = false;
  bool timing = false;
};

/// Adds everything that `gearbox optimize` takes.
void add_optimize_options(command_line::Command& command, OptimizeRequest& request);

}  // namespace torquewright::cli
