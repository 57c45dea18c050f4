// SPDX-License-Identifier: Apache-2.0
#include "src/interrupt.hpp"

#include <csignal>

namespace torquewright::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void on_interrupt(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

void catch_interrupt() {
  interrupted = 0;
  std::signal(SIGINT, on_interrupt);
}
bool is_interrupted() { return interrupted != 0; }

}  // namespace torquewright::cli
