// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimization/nonlinear/options.hpp"
#include "optimization/nonlinear/program.hpp"
#include "optimization/nonlinear/status.hpp"

namespace torquewright::optimization {

struct NonlinearSolution {
  NonlinearStatus status = NonlinearStatus::kStalled;
  /// The point where the search ended if it solved; else the best that it met: of those within the
  /// tolerance of all rows the cheapest, else the least violating; the start where none was finite.
  std::vector<double> values;
  double objective = 0.0;  ///< Objective at `values`; infinite where no point was finite.
  /// Largest violation of rows over their scales, at `values`; bounds hold.
  double largest_violation = 0.0;
  /// Multipliers of the unscaled rows, in the program's order; empty unless solved. The objective's
  /// slopes plus J^T multipliers vanish but for bounds: a multiplier above 0 belongs to an active
  /// upper bound, one below 0 to a lower one; raising that bound by a little changes the objective
  /// by -multiplier times it.
  std::vector<double> multipliers;
  int iterations = 0;
  double seconds = 0.0;
  double derivative_seconds = 0.0;  ///< Seconds spent in values and derivatives of rows.

  bool is_solved() const {
    return status == NonlinearStatus::kSolved || status == NonlinearStatus::kAcceptable;
  }
};

/// Finds a local optimum by Ipopt: monotone barrier, exact derivatives, MUMPS. Deterministic but
/// for limits of time. Does not throw for what the search meets; exceptions of rows and of the
/// options' functions pass through, and std::invalid_argument where tolerance or barrier are not
/// positive and finite or a limit is negative or no number (docs/derivations/nonlinear_program.md).
[[nodiscard]] NonlinearSolution solve(const Program& program, const NonlinearOptions& options);

}  // namespace torquewright::optimization
