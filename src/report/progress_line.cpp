// SPDX-License-Identifier: Apache-2.0
#include "src/report/progress_line.hpp"

#include <unistd.h>

#include <cstdio>

#include "src/interrupt.hpp"
#include "src/sweep/sweep.hpp"

namespace torquewright::report {

ProgressLine::ProgressLine() : is_watched_(isatty(STDERR_FILENO) == 1 && !sweep::is_silent()) {}
ProgressLine::~ProgressLine() { write(""); }

void ProgressLine::show(const std::string& text) {
  cli::leave_if_interrupted();
  write(text);
}

void ProgressLine::write(const std::string& text) const {
  if (is_watched_) std::fprintf(stderr, "\r\033[K%s", text.c_str());
}

}  // namespace torquewright::report
