// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "src/sweep/worker_process.hpp"

namespace torquewright::sweep {

/// Several workers at once. One that ends is replaced by the next that is needed.
class WorkerPool {
 public:
  WorkerPool(std::size_t jobs, std::string fingerprint);

  bool has_room() const { return busy() < jobs_; }
  std::size_t busy() const;
  /// Has a worker begin that point; requires room.
  void start(std::size_t point);
  /// Returns what has been answered, or lost, by then; waits no longer than that for the first.
  /// Throws io::SpecError and std::runtime_error as run_sweep() does.
  std::vector<PointAnswer> wait(std::chrono::milliseconds patience);

 private:
  void note_end(const WorkerProcess& worker, std::vector<PointAnswer>& answers);

  std::size_t jobs_;
  std::string fingerprint_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;
  std::size_t failed_starts_ = 0;       ///< In a row.
  std::vector<std::size_t> not_begun_;  ///< Points of workers that never came to them.
};

}  // namespace torquewright::sweep
