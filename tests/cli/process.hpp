// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace torquewright::cli_test {

/// Sent to the program alone, not to processes that it has started.
struct Signal {
  int number = 0;
  std::chrono::microseconds after{};  ///< From its start.
};

/// Under what circumstances the program runs.
struct Circumstances {
  std::filesystem::path folder = ".";       ///< Its working directory.
  std::optional<rlim_t> file_size_limit{};  ///< Of files it writes, as on a full disk [bytes].
  std::optional<rlim_t> memory_limit{};     ///< Of its address space [bytes].
  std::optional<rlim_t> stack_limit{};      ///< [bytes]
  /// Ctrl-C so long after it has begun to listen for it.
  std::optional<std::chrono::milliseconds> interrupt_after{};
  std::optional<Signal> signal{};
  bool ignores_interrupt = false;          ///< As a shell starts what is in the background.
  bool closes_stderr = false;              ///< As by `2>&-`.
  bool as_nobody = false;                  ///< Without root's rights. Requires root.
  std::filesystem::path stdout_file{};     ///< Instead of a pipe, as by `>>`; `out` stays empty.
  std::vector<std::string> environment{};  ///< More variables, NAME=VALUE.
};

/// What came of it.
struct Outcome {
  int exit_code = -1;  ///< -1: ended by a signal, or did not end within two minutes.
  int signal = 0;      ///< That ended it.
  /// Within two minutes, and so did all processes that it had started.
  bool has_ended = false;
  std::string out;
  std::string err;
};

/// Exit code of the child where the program cannot be started.
constexpr int kNotStarted = 126;

/// Runs build/.../torquewright with these arguments, without a shell.
Outcome run(const std::vector<std::string>& arguments, const Circumstances& circumstances = {});

/// Starts it and sends it that signal after a while. False: it went on for twenty seconds more.
/// Requires that it prints little.
bool run_and_kill(const std::vector<std::string>& arguments, const Circumstances& circumstances,
                  int signal, std::chrono::microseconds after);

}  // namespace torquewright::cli_test
