// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::bench {

struct ProcessOutcome {
  bool started = false;
  bool timed_out = false;
  int exit_code = -1;      ///< -1 if it did not end by itself.
  double seconds = 0;      ///< Wall clock from start to end.
  double cpu_seconds = 0;  ///< Of the program and of what it waited for.
  double peak_MB = 0;      ///< Greatest resident memory.
  std::string output;      ///< Of stdout; stderr is dropped.
};

/// Runs a program found in PATH with exactly these arguments, no shell in between, in a process
/// group of its own that is ended as a whole at the time-out.
ProcessOutcome run_process(const std::vector<std::string>& arguments, double timeout_s);

}  // namespace torquewright::bench
