// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "src/exit_code.hpp"

namespace torquewright::command_line {

/// What `main` returns after this work. What stopped it goes to stderr: io::SpecError is bad input;
/// any other exception says nothing of the input (EX_SOFTWARE, 70).
int exit_status(const std::function<cli::ExitCode()>& work);

}  // namespace torquewright::command_line
