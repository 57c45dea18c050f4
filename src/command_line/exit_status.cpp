// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/exit_status.hpp"

#include <cstdio>
#include <exception>

#include "io/spec_error.hpp"

namespace torquewright::command_line {

int exit_status(const std::function<cli::ExitCode()>& work) {
  try {
    return static_cast<int>(work());
  } catch (const io::SpecError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(cli::ExitCode::kBadInput);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
    return 70;
  }
}

}  // namespace torquewright::command_line
