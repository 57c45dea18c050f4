// SPDX-License-Identifier: Apache-2.0
#include "src/interrupt.hpp"

#include <csignal>

namespace torquewright::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

/// What ForwardedInterrupt found, for its handler, which can be given nothing else.
bool is_forwarding = false;
struct sigaction before {};

extern "C" void on_interrupt(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

extern "C" void on_forwarded_interrupt(int signal, siginfo_t* info, void* context) {
  interrupted = 1;
  if ((before.sa_flags & SA_SIGINFO) != 0) {
    before.sa_sigaction(signal, info, context);
  } else {
    before.sa_handler(signal);
  }
}

/// By whoever started us: a job in the background is not for Ctrl-C.
bool is_ignored(int signal) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && (now.sa_flags & SA_SIGINFO) == 0 &&
         now.sa_handler == SIG_IGN;
}

bool is_handled(const struct sigaction& action) {
  if ((action.sa_flags & SA_SIGINFO) != 0) return true;
  return action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN;
}

}  // namespace

void catch_interrupt() {
  if (is_forwarding) return;
  interrupted = 0;
  if (is_ignored(SIGINT)) return;
  std::signal(SIGINT, on_interrupt);
}

bool is_interrupted() { return interrupted != 0; }

void interrupt_forwarded() { interrupted = 1; }

ForwardedInterrupt::ForwardedInterrupt() {
  interrupted = 0;
  is_forwarding = true;
  if (sigaction(SIGINT, nullptr, &before) != 0 || !is_handled(before)) return;
  struct sigaction ours = before;
  ours.sa_flags |= SA_SIGINFO;
  ours.sa_sigaction = on_forwarded_interrupt;
  sigaction(SIGINT, &ours, nullptr);
}

ForwardedInterrupt::~ForwardedInterrupt() {
  if (is_handled(before)) sigaction(SIGINT, &before, nullptr);
  is_forwarding = false;
}

void leave_if_interrupted() {
  if (is_forwarding && is_interrupted()) throw Interrupted();
}

}  // namespace torquewright::cli
