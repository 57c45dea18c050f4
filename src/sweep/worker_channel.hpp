// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/sweep/request.hpp"

namespace torquewright::sweep {

/// A line of text between a worker and who started it. Down: a point's number. Up: "ready
/// FINGERPRINT", then for each point "done NUMBER ROW" or "lost NUMBER WHY".
struct WorkerLine {
  enum class Kind { kReady, kDone, kLost, kUnknown };
  Kind kind = Kind::kUnknown;
  std::size_t point = 0;
  std::string text;
};
WorkerLine read_worker_line(std::string_view line);
std::string written(const PointAnswer& answer);

/// Takes the whole lines out of what has come.
std::vector<std::string> take_lines(std::string& bytes);

/// The environment's variable by which a process knows that it is a worker: the number of the
/// process that started it. Descriptors that it reads from and writes to are away from those that a
/// shell hands over.
inline constexpr const char* kWorkerVariable = "TORQUEWRIGHT_SWEEP_WORKER";
inline constexpr int kWorkerReads = 100;
inline constexpr int kWorkerWrites = 101;

bool is_worker();

/// Lets a worker end with the process that started it, even if that one is killed. To be called
/// first of all.
void end_with_starter();

/// The worker's side: answers points until there are no more.
void serve(const Request& request, const Evaluate& evaluate);

}  // namespace torquewright::sweep
