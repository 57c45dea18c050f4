// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace torquewright::io {

/// While one lives, signals that would end the program wait for it, in this thread: files that are
/// replaced together are all there afterwards, or none. The signals of faults do not wait, for the
/// work could not go on, nor those that no program can hold.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

}  // namespace torquewright::io
