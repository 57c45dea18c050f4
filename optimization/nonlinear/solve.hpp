// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "optimization/nonlinear/program.hpp"

namespace torquewright::optimization {

/// How a search for a local optimum ended.
enum class NonlinearStatus {
  kSolved,             ///< First-order conditions hold to the tolerance.
  kAcceptable,         ///< They hold to a hundred times the tolerance and would not get better.
  kLocallyInfeasible,  ///< No step makes the violation less. Proves nothing about other places.
  kIterationLimit,
  kTimeLimit,
  kInterrupted,
  kDiverged,     ///< The unknowns ran away.
  kStalled,      ///< Steps became too small, or restoration failed.
  kBadNumbers,   ///< A row or a derivative is not finite.
  kOverdefined,  ///< More equations than unknowns.
};
std::string_view name_of(NonlinearStatus status);

/// What someone who waits may see of each iteration.
struct NonlinearIterate {
  int iteration = 0;
  double objective = 0.0;
  double largest_violation = 0.0;  ///< Of the scaled rows.
};

struct NonlinearOptions {
  double tolerance = 1e-7;  ///< Of scaled optimality and of scaled violation.
  int most_iterations = 1000;
  double most_seconds = std::numeric_limits<double>::infinity();  ///< On the wall clock.
  /// Barrier at which the search begins. Small ones keep a good start; too small stalls at bounds.
  double first_barrier = 0.1;
  std::function<bool()> should_stop = {};                                ///< May be empty.
  std::function<void(const NonlinearIterate& iterate)> on_iterate = {};  ///< May be empty.
};

struct NonlinearSolution {
  NonlinearStatus status = NonlinearStatus::kStalled;
  /// Where the search ended if it solved; else the best that it met: of those within the tolerance
  /// of all rows the cheapest, else the least violating.
  std::vector<double> values;
  double objective = 0.0;
  double largest_violation = 0.0;  ///< Of rows over their scales, at `values`; bounds hold.
  /// By row of the program, of the unscaled rows; where solved, else empty. The objective's slopes
  /// plus J^T multipliers vanish but for bounds: above 0 an upper bound holds a row back, below 0 a
  /// lower one; raising that bound by a little changes the objective by -multiplier times it.
  std::vector<double> multipliers;
  int iterations = 0;
  double seconds = 0.0;
  double derivative_seconds = 0.0;  ///< Of them in values and derivatives of rows.

  bool is_solved() const {
    return status == NonlinearStatus::kSolved || status == NonlinearStatus::kAcceptable;
  }
};

/// A local optimum, by Ipopt: monotone barrier, exact derivatives, MUMPS. Deterministic but for
/// limits of time. Never throws for what the search meets; what rows throw comes through, and
/// std::invalid_argument where tolerance or barrier are not positive.
NonlinearSolution solve(const Program& program, const NonlinearOptions& options);

}  // namespace torquewright::optimization
