// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::cli {

/// Makes Ctrl-C (SIGINT) a request from now on, which does not end the program: long work asks
/// is_interrupted() and ends with what it has. A second Ctrl-C ends it at once. Called again, it
/// waits for another.
void catch_interrupt();
bool is_interrupted();

/// As Ctrl-C does while the work is done inside another program.
void interrupt_forwarded();

/// While one lives, the program's work is done inside another program (an interpreter): Ctrl-C is
/// noted, and goes on to the handler that was there before, on which catch_interrupt() then has no
/// effect. Where nobody handled it, nothing changes. At most one at a time.
class ForwardedInterrupt {
 public:
  ForwardedInterrupt();
  ~ForwardedInterrupt();
  ForwardedInterrupt(const ForwardedInterrupt&) = delete;
  ForwardedInterrupt& operator=(const ForwardedInterrupt&) = delete;
};

/// Thrown by work that has no answer before its end.
struct Interrupted {};

/// Throws Interrupted after a Ctrl-C that was forwarded. Elsewhere Ctrl-C ends the program, or it
/// was caught and the work ends with what it has.
void leave_if_interrupted();

}  // namespace torquewright::cli
