// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "tests/fuzz/program/case.hpp"

namespace torquewright::fuzz {

class ForkClient;

/// Where and how long the program runs.
struct Circumstances {
  std::filesystem::path program;
  std::filesystem::path folder;          ///< Its working directory.
  std::filesystem::path temporary;       ///< Its TMPDIR.
  std::chrono::milliseconds patience{};  ///< Then it is killed.
  /// Somebody who reads them to the end. Pipes that do not exist are not read.
  std::vector<std::filesystem::path> pipes{};
  ForkClient* copies = nullptr;  ///< Of what the run is a copy; nothing: it is started anew.
};

struct Kill {
  int signal = 0;
  std::chrono::microseconds after{};
};

struct Outcome {
  int exit_code = -1;        ///< -1: by a signal.
  int signal = 0;            ///< That ended it.
  bool has_ended = true;     ///< Before the patience was over.
  double processor_s = 0.0;  ///< Of all its threads.
  double clock_s = 0.0;
  double resident_MB = 0.0;  ///< At most.
  std::string out, err;      ///< Each cut off at kMostOutput.
};

inline constexpr std::size_t kMostOutput = 64 << 20;

/// Runs it once, without a shell.
Outcome run(const Words& arguments, const Circumstances& circumstances,
            const std::optional<Kill>& kill = {});

}  // namespace torquewright::fuzz
