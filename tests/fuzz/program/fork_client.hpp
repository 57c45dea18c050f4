// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include "tests/fuzz/program/fork_channel.hpp"
#include "tests/fuzz/program/runner.hpp"

namespace torquewright::fuzz {

/// A program that loads its libraries once and runs as often as it is asked (fork_server.cpp); one
/// run at a time.
class ForkClient {
 public:
  /// Throws where it does not start.
  explicit ForkClient(const std::filesystem::path& server);
  ~ForkClient();
  ForkClient(const ForkClient&) = delete;
  ForkClient& operator=(const ForkClient&) = delete;

  /// The number of the process. It writes to the descriptors, which may be closed then.
  pid_t start(const Words& arguments, const Circumstances& circumstances, int standard_output,
              int standard_error);
  /// Until it has ended.
  RunEnd wait();

 private:
  int channel_ = -1;
  pid_t server_ = -1;
};

}  // namespace torquewright::fuzz
