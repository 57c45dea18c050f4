// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/search/plan.hpp"

#include <chrono>

#include "hopper/planning/search/explanation.hpp"
#include "hopper/planning/search/plan_search.hpp"

namespace torquewright::hopper {

std::string_view name_of(PlanStatus status) {
  switch (status) {
    case PlanStatus::kPlanned:
      return "planned";
    case PlanStatus::kLocallyInfeasible:
      return "locally_infeasible";
    default:
      return "limit";
  }
}

std::optional<double> reserve_price(const std::vector<BoundPrice>& prices) {
  double sum = 0.0;
  bool has_any = false;
  for (const BoundPrice& part : prices) {
    if (!(part.per_reserve > 0.0)) continue;
    if (!part.objective_per_unit) return std::nullopt;
    sum += part.per_reserve * *part.objective_per_unit;
    has_any = true;
  }
  if (!has_any) return std::nullopt;
  return sum;
}

PlanResult plan_motion(const Robot& robot, const PlanOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  PlanResult result = search_plan(robot, options);
  if (options.explain && can_be_explained(result.status)) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    result.changes = changes_that_help(robot, options, options.most_seconds - spent.count());
  }
  return result;
}

}  // namespace torquewright::hopper
