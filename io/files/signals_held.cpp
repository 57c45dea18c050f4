// SPDX-License-Identifier: Apache-2.0
#include "io/files/signals_held.hpp"

#include <initializer_list>

namespace torquewright::io {

SignalsHeld::SignalsHeld() {
  sigset_t held;
  ::sigfillset(&held);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGSYS}) {
    ::sigdelset(&held, fault);
  }
  ::pthread_sigmask(SIG_BLOCK, &held, &before_);
}

SignalsHeld::~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

}  // namespace torquewright::io
