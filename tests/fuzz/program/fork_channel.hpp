// SPDX-License-Identifier: Apache-2.0
// Between the fuzzer and the server that makes its runs: both know these.
#pragma once

#include <sys/resource.h>

#include <cstddef>
#include <vector>

#include "tests/fuzz/program/case.hpp"

namespace torquewright::fuzz {

/// The number of the channel's descriptor.
inline constexpr const char* kForkChannelVariable = "TORQUEWRIGHT_FORK_CHANNEL";
/// The exit code of a run that did not come to be.
inline constexpr int kNotStarted = 126;

/// Places in a request; behind them stand the arguments.
enum RequestPlace : std::size_t { kFolder, kTemporary, kStandardOutput, kStandardError, kProgram };

struct RunEnd {
  int status = 0;
  rusage used{};
};

bool send_bytes(int channel, const void* bytes, std::size_t count);
bool receive_bytes(int channel, void* bytes, std::size_t count);

template <typename Value>
bool send_value(int channel, const Value& value) {
  return send_bytes(channel, &value, sizeof value);
}

template <typename Value>
bool receive_value(int channel, Value& value) {
  return receive_bytes(channel, &value, sizeof value);
}

/// False where the other side has ended. Words end at their first zero byte, as arguments do.
bool send(int channel, const Words& request);
bool receive(int channel, Words& request);

}  // namespace torquewright::fuzz
