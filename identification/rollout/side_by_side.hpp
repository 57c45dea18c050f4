// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/log/log.hpp"
#include "simulation/in_parallel.hpp"

namespace torquewright::identification {

/// What `work` gives for 0 ... count - 1, in that order, computed by several threads at once; one
/// after another where the log does not lie in memory, for a file gives one run at a time.
template <typename Result, typename Work>
std::vector<Result> side_by_side(const Log& log, std::size_t count, const Work& work) {
  std::vector<Result> results(count);
  const std::size_t threads = log.runs.is_in_memory() ? simulation::threads_of_machine() : 1;
  simulation::in_parallel(count, threads,
                          [&](std::size_t k, std::size_t) { results[k] = work(k); });
  return results;
}

}  // namespace torquewright::identification
