// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimization/nonlinear/options.hpp"
#include "optimization/nonlinear/program.hpp"
#include "optimization/nonlinear/status.hpp"

namespace torquewright::optimization {

struct NonlinearSolution {
  NonlinearStatus status = NonlinearStatus::kStalled;
  /// Where the search ended if it solved; else the best that it met: of those within the tolerance
  /// of all rows the cheapest, else the least violating; the start where none was finite.
  std::vector<double> values;
  double objective = 0.0;          ///< Infinite where no point was finite.
  double largest_violation = 0.0;  ///< Of rows over their scales, at `values`; bounds hold.
  /// Multipliers of the unscaled rows, in the program's order; where solved, else empty. The
  /// objective's slopes plus J^T multipliers vanish but for bounds: above 0 an upper bound holds a
  /// row back, below 0 a lower one; raising that bound by a little changes the objective by
  /// -multiplier times it.
  std::vector<double> multipliers;
  int iterations = 0;
  double seconds = 0.0;
  double derivative_seconds = 0.0;  ///< Of them in values and derivatives of rows.

  bool is_solved() const {
    return status == NonlinearStatus::kSolved || status == NonlinearStatus::kAcceptable;
  }
};

/// A local optimum, by Ipopt: monotone barrier, exact derivatives, MUMPS. Deterministic but for
/// limits of time. Never throws for what the search meets; what rows and the options' functions
/// throw comes through, and std::invalid_argument where tolerance or barrier are not positive and
/// finite or a limit is negative or no number. docs/derivations/nonlinear_program.md.
[[nodiscard]] NonlinearSolution solve(const Program& program, const NonlinearOptions& options);

}  // namespace torquewright::optimization
