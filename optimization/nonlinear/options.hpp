// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>

namespace torquewright::optimization {

/// What someone who waits may see of each iteration: the point that was evaluated last, which is
/// the iterate unless steps were taken back.
struct NonlinearIterate {
  int iteration = 0;
  double objective = 0.0;
  double largest_violation = 0.0;  ///< Of the scaled rows.
};

struct NonlinearOptions {
  double tolerance = 1e-7;  ///< Of scaled optimality and of scaled violation.
  int most_iterations = 1000;
  /// On the wall clock, looked at in each iteration.
  double most_seconds = std::numeric_limits<double>::infinity();
  /// Barrier at which the search begins. Small ones keep a good start; too small stalls at bounds.
  double first_barrier = 0.1;
  std::function<bool()> should_stop = {};                                ///< May be empty.
  std::function<void(const NonlinearIterate& iterate)> on_iterate = {};  ///< May be empty.
};

}  // namespace torquewright::optimization
