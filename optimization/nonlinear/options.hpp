// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>

namespace torquewright::optimization {

/// State of an iteration for progress reports: the point that was evaluated last, which is the
/// iterate unless steps were taken back.
struct NonlinearIterate {
  int iteration = 0;
  double objective = 0.0;
  double largest_violation = 0.0;  ///< Largest violation of the scaled rows.
};

struct NonlinearOptions {
  double tolerance = 1e-7;  ///< Tolerance of scaled optimality and of scaled violation.
  int most_iterations = 1000;
  /// Limit of wall-clock time, looked at in each iteration.
  double most_seconds = std::numeric_limits<double>::infinity();
  /// Barrier at which the search begins. A small one keeps a good start; one that is too small
  /// stalls at bounds.
  double first_barrier = 0.1;
  std::function<bool()> should_stop = {};  ///< Called to ask whether to stop. May be empty.
  /// Called after each iteration. May be empty.
  std::function<void(const NonlinearIterate& iterate)> on_iterate = {};
};

}  // namespace torquewright::optimization
