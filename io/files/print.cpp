// SPDX-License-Identifier: Apache-2.0
#include "io/files/print.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "io/faults/spec_error.hpp"
#include "io/files/file_session.hpp"

namespace torquewright::io {

void print(const std::string& text) {
  for (const auto& [descriptor, name] :
       {std::pair{STDOUT_FILENO, "standard output"}, std::pair{STDERR_FILENO, "standard error"}}) {
    if (!is_input(descriptor)) continue;
    throw SpecError({{name, "", "leads into an input, which would be lost"}});
  }
  if (std::fputs(text.c_str(), stdout) != EOF && std::fflush(stdout) == 0) return;
  const std::string reason = std::generic_category().message(errno);
  throw SpecError({{"standard output", "", "cannot be written: " + reason}});
}

}  // namespace torquewright::io
