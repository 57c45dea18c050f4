// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/tasks/plan_goal.hpp"

namespace torquewright::hopper {

/// Sets what the goal asks of each flight where the foot goes somewhere: strides by the speed where
/// none is stated, the ground on which each flight lands and its edges, which lie midway between
/// where the foot stands before and after. io::SpecError, naming the option, where the ground is
/// said of more landings than there are, where a foot does not stand flat between two flights over
/// an edge, or has no room beside one.
void set_hops(const std::vector<Stance>& stances, const PlanModel& model,
              const PlanOptions& options, PlanGoal& goal);

}  // namespace torquewright::hopper
