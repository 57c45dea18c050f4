// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <vector>

#include "optimization/nonlinear/assembly.hpp"
#include "optimization/nonlinear/options.hpp"
#include "optimization/nonlinear/status.hpp"

namespace torquewright::optimization {

/// A point with its objective and violation.
struct Candidate {
  std::vector<double> values;  ///< Values of the unknowns; empty as long as there is no point.
  double objective = 0.0;
  double largest_violation = 0.0;
};

/// Whether a point is better: within the tolerance of all rows the cheaper one, else the less
/// violating one. One key, so that the order of the two does not matter.
bool is_better(const Evaluation& trial, const Candidate& best, double tolerance);

/// State of one search, whichever solver steers it: evaluates the scaled program, keeps the best
/// point of all that were evaluated (those of a restoration phase and those rejected too), and
/// measures time. Program and options must outlive it. Exceptions of rows pass through.
class Search {
 public:
  Search(const Program& program, const NonlinearOptions& options);

  const Program& program() const { return program_; }
  const NonlinearOptions& options() const { return options_; }
  const Assembly& assembly() const { return assembly_; }
  const Candidate& best() const { return best_; }

  /// Evaluates as the functions of Assembly of the same names do.
  const Evaluation& at(std::span<const double> scaled);
  bool gradient(std::span<const double> scaled, std::span<double> slopes);
  bool jacobian(std::span<const double> scaled, std::span<double> entries);
  bool hessian(std::span<const double> scaled, double objective_factor,
               std::span<const double> multipliers, std::span<double> entries);
  /// Objective and violation where they were finite last; its iteration number is not used.
  const NonlinearIterate& last_finite() const { return last_finite_; }

  /// Returns kTimeLimit or kInterrupted where the search should end now.
  std::optional<NonlinearStatus> interruption() const;
  double seconds() const;
  double derivative_seconds() const { return derivative_seconds_; }

 private:
  const Program& program_;
  const NonlinearOptions& options_;
  std::chrono::steady_clock::time_point begin_;
  Assembly assembly_;
  Candidate best_;
  NonlinearIterate last_finite_;
  double derivative_seconds_ = 0.0;
};

}  // namespace torquewright::optimization
