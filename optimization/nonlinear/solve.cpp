// SPDX-License-Identifier: Apache-2.0
#include "optimization/nonlinear/solve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "optimization/nonlinear/ipopt_program.hpp"

namespace torquewright::optimization {
namespace {

void require_sound(const NonlinearOptions& options) {
  const auto is_size = [](double value) { return value > 0.0 && std::isfinite(value); };
  const bool is_sound = is_size(options.tolerance) && is_size(options.first_barrier) &&
                        options.most_iterations >= 0 && options.most_seconds >= 0.0;
  if (is_sound) return;
  throw std::invalid_argument(
      "a nonlinear search needs a positive tolerance and barrier, and limits that are not "
      "negative");
}

std::vector<double> scaled_starts(const Program& program) {
  std::vector<double> scaled = program.starts();
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] /= program.scales()[i];
  return scaled;
}

/// What needs no steps.
std::optional<NonlinearStatus> status_without_steps(Search& search,
                                                    const std::vector<double>& starts) {
  const Evaluation& start = search.at(starts);
  if (!start.is_finite) return NonlinearStatus::kBadNumbers;
  const int freedom = search.program().free_variable_count();
  if (search.program().equation_count() > freedom) return NonlinearStatus::kOverdefined;
  if (const auto interruption = search.interruption()) return interruption;
  if (freedom > 0) return std::nullopt;
  const bool holds = start.largest_violation <= search.options().tolerance;
  return holds ? NonlinearStatus::kSolved : NonlinearStatus::kLocallyInfeasible;
}

void take_point(NonlinearSolution& solution, Search& search, const SearchEnd& end) {
  const Candidate& best = search.best();
  if (!solution.is_solved() && !best.values.empty()) {
    solution.values = best.values;
    solution.objective = best.objective;
    solution.largest_violation = best.largest_violation;
    return;
  }
  const Evaluation& last = search.at(end.scaled);
  solution.values = last.values;
  solution.objective = last.is_finite ? last.objective : HUGE_VAL;
  solution.largest_violation = last.is_finite ? last.largest_violation : HUGE_VAL;
}

// lambda of the unscaled rows and objective, eq. (3) of docs/derivations/nonlinear_program.md.
std::vector<double> unscaled_multipliers(const Search& search, std::vector<double> multipliers) {
  const double objective_scale = search.assembly().objective_scale();
  auto next = multipliers.begin();
  for (const auto& rows : search.program().rows()) {
    for (const double scale : rows->scales()) *next++ *= objective_scale / scale;
  }
  return multipliers;
}

}  // namespace

NonlinearSolution solve(const Program& program, const NonlinearOptions& options) {
  require_sound(options);
  Search search(program, options);
  const std::vector<double> starts = scaled_starts(program);
  SearchEnd end;
  if (const auto status = status_without_steps(search, starts)) {
    end.status = *status;
    end.scaled = starts;
    end.multipliers.assign(static_cast<std::size_t>(program.row_count()), 0.0);
  } else {
    end = run_ipopt(search);
  }
  NonlinearSolution solution;
  solution.status = end.status;
  solution.iterations = end.iterations;
  take_point(solution, search, end);
  if (solution.is_solved()) {
    solution.multipliers = unscaled_multipliers(search, std::move(end.multipliers));
  }
  solution.seconds = search.seconds();
  solution.derivative_seconds = search.derivative_seconds();
  return solution;
}

}  // namespace torquewright::optimization
