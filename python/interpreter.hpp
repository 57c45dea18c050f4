// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>
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
/// for bad input; after Ctrl-C KeyboardInterrupt, as a Python exception. Progress, a function of a
/// text or None, hears how far long work is; what it raises ends the work and is raised. It may ask
/// nothing of the program itself (std::runtime_error).
Answer run(const std::vector<std::string>& words, const pybind11::object& progress);

}  // namespace torquewright::python
