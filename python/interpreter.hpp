// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "src/exit_code.hpp"

namespace torquewright::python {

/// What a command of the program printed, and how it ended.
struct Answer {
  cli::ExitCode code;
  std::string text;
};

/// Runs the program's command in this process: the words behind the program's name. Calls from
/// several threads wait for one another; the interpreter goes on meanwhile. Throws io::SpecError
/// for bad input; after Ctrl-C KeyboardInterrupt, as a Python exception.
Answer run(const std::vector<std::string>& words);

}  // namespace torquewright::python
