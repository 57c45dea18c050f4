// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/sweep/answer.hpp"

namespace torquewright::sweep {

/// Points that are done one by one, each by its number alone.
struct Request {
  std::vector<std::string> points;  ///< Their names, each once.
  /// A fingerprint of all that the answers depend on beside the point: options, inputs, program.
  /// Workers state theirs, and a journal's lines are taken where it is the same.
  std::string fingerprint;
  std::string journal_file;  ///< Empty: none is kept, and nothing outlives this run.
  std::size_t jobs = 0;      ///< Processes; 0: as many as the processor runs at once.
};

/// What came of the points, in their order; none: it was stopped before.
struct Outcome {
  std::vector<std::optional<Answer>> answers;
};

struct Watching {
  std::function<bool()> should_stop;                                   ///< May be empty.
  std::function<void(std::size_t done, std::size_t all)> on_progress;  ///< May be empty.
};

/// The answer of a point, JSON on one line. Called in a worker process, never in the caller's.
using Evaluate = std::function<std::string(std::size_t point)>;

}  // namespace torquewright::sweep
