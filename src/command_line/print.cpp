// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/print.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "io/spec_error.hpp"

namespace torquewright::command_line {

void print(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) != EOF && std::fflush(stdout) == 0) return;
  const std::string reason = std::generic_category().message(errno);
  throw io::SpecError({{"standard output", "", "cannot be written: " + reason}});
}

}  // namespace torquewright::command_line
