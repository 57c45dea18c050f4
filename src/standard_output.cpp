// SPDX-License-Identifier: Apache-2.0
#include "src/standard_output.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "io/atomic_file.hpp"
#include "io/spec_error.hpp"

namespace torquewright::cli {

void print_result(const std::string& text) {
  // A full disk may show as late as when the buffer is emptied.
  if (std::fputs(text.c_str(), stdout) != EOF && std::fflush(stdout) == 0) return;
  const std::string reason = std::generic_category().message(errno);
  throw io::SpecError({{"standard output", "", "cannot be written: " + reason}});
}

void deliver_result(const std::string& text, const std::string& file) {
  if (file.empty()) {
    print_result(text);
  } else {
    io::write_whole_file(file, text);
  }
}

}  // namespace torquewright::cli
