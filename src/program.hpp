// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/exit_code.hpp"

namespace torquewright::cli {

/// All of the program but what a process has once (its streams, its session of files): reads the
/// arguments, of which the first is the program's name, and runs the command that they name. Throws
/// io::SpecError for bad input.
ExitCode run_program(int argc, const char* const* argv);

}  // namespace torquewright::cli
