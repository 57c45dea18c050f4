// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/plan.hpp"

#include <chrono>

#include "hopper/flip/explanation.hpp"
#include "hopper/flip/plan_search.hpp"

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
