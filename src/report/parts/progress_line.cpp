// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/progress_line.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "src/interrupt.hpp"
#include "src/loudness.hpp"
#include "src/sweep/sweep.hpp"

namespace torquewright::report {

namespace {

/// That fit into a row of the window: what goes on in a second row could not be taken back. The
/// terminal writes ^C behind it, where that is typed.
int columns() {
  constexpr int kUsual = 80, kTyped = 3;
  winsize size{};
  const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > kTyped;
  return (is_known ? size.ws_col : kUsual) - kTyped;
}

std::function<void(const std::string&)>& listener() {
  static std::function<void(const std::string&)> living;
  return living;
}

}  // namespace

ProgressListener::ProgressListener(std::function<void(const std::string&)> heard) {
  listener() = std::move(heard);
}
ProgressListener::~ProgressListener() { listener() = nullptr; }

ProgressLine::ProgressLine()
    : is_watched_(isatty(STDERR_FILENO) == 1 && !sweep::is_silent() && !cli::loudness().is_quiet) {}
ProgressLine::~ProgressLine() { write(""); }

void ProgressLine::show(const std::string& text) {
  cli::leave_if_interrupted();
  if (listener()) return listener()(text);
  write(text);
}

void ProgressLine::write(const std::string& text) const {
  if (is_watched_) std::fprintf(stderr, "\r\033[K%.*s", columns(), text.c_str());
}

}  // namespace torquewright::report
