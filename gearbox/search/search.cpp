// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/search.hpp"

#include <algorithm>
#include <cmath>

#include "gearbox/search/alternatives.hpp"
#include "gearbox/search/conflict.hpp"
#include "optimization/discrete/relaxation.hpp"

namespace torquewright::gearbox {
namespace {

using optimization::SearchStatus;
using optimization::Solution;

double as_read(double cost, const optimization::Goal& goal) { return goal.maximise ? -cost : cost; }

optimization::SearchOptions search_options(const DesignSearchOptions& options,
                                           const optimization::Goal& goal) {
  optimization::SearchOptions result;
  result.wanted = options.top;
  result.relaxation = options.relaxation;
  result.max_nodes = options.max_nodes;
  result.should_stop = options.should_stop;
  result.report = [&](optimization::Progress progress) {
    progress.best_cost = as_read(progress.best_cost, goal);
    progress.bound = as_read(progress.bound, goal);
    options.report(progress);
  };
  result.on_close = options.on_close;
  return result;
}

void list_solutions(const std::vector<Solution>& solutions, std::size_t top,
                    const Alternatives& alternatives, DesignSearchResult& result) {
  for (const Solution& solution : solutions) {
    if (result.designs.size() < top) {
      result.designs.push_back(alternatives.design(solution));
      result.objectives.push_back(as_read(solution.cost.nearest(), alternatives.goal()));
    } else {
      result.ties.push_back(alternatives.design(solution));
    }
  }
}

std::optional<double> bound_as_read(const optimization::SearchResult& found,
                                    const DesignSearchResult& result,
                                    const optimization::Goal& goal) {
  if (found.status == SearchStatus::kComplete) {
    return result.objectives.empty() ? std::nullopt : std::optional(result.objectives.front());
  }
  return std::isfinite(found.bound) ? std::optional(as_read(found.bound, goal)) : std::nullopt;
}

}  // namespace

DesignSearchResult optimize(const Problem& problem, const DesignSearchOptions& options) {
  const Alternatives alternatives(problem);
  optimization::SearchResult found =
      optimization::minimise(alternatives.judges(), search_options(options, alternatives.goal()));
  DesignSearchResult result;
  list_solutions(found.solutions, options.top, alternatives, result);
  result.bound = bound_as_read(found, result, alternatives.goal());
  if (found.status == SearchStatus::kComplete && result.designs.empty()) {
    explain_infeasibility(problem, options, alternatives.proofs(std::move(found.proofs)), found,
                          result);
    return result;
  }
  add_to(result.search, found);
  result.status = found.status == SearchStatus::kComplete ? DesignSearchStatus::kOptimal
                                                          : DesignSearchStatus::kLimit;
  const bool is_full = result.designs.size() >= options.top;
  result.claims.push_back({"optimum", alternatives.constraints(), alternatives.goal().name,
                           is_full ? std::optional(result.designs.back()) : std::nullopt, "",
                           std::nullopt, alternatives.proofs(std::move(found.proofs))});
  return result;
}

bool can_be_relaxed(const Problem& problem) {
  const Alternatives alternatives(problem);
  return std::any_of(alternatives.judges().begin(), alternatives.judges().end(),
                     optimization::has_shape);
}

}  // namespace torquewright::gearbox
