// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/exit_code.hpp"

namespace torquewright::python {

/// Hears how far long work is, in a terminal's words; any answer but 0 ends the work.
using Tell = int (*)(const char* text);

/// What a command of the program printed, and how it ended.
struct Ended {
  cli::ExitCode code = cli::ExitCode::kUndecided;
  std::string text;
  bool is_interrupted = false;  ///< By Ctrl-C, or by who was told.
};

/// Runs the program's command in this process: the words behind the program's name. Calls from
/// several threads wait for one another. Throws io::SpecError for bad input. `tell` may be null; it
/// may ask nothing of the program itself (std::runtime_error).
Ended run(const std::vector<const char*>& words, Tell tell);

}  // namespace torquewright::python
