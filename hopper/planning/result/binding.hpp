// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"
#include "hopper/planning/result/plan_result.hpp"

namespace torquewright::hopper {

/// Returns what holds a plan back: the limits of constraints (planning margins taken off) that the
/// plan reaches or exceeds, over the instants at which they hold, the most often binding first.
/// After them come the rows of the program that the values violate, the worst first; their
/// violations are shares of the rows' scales, and they have no times.
std::vector<BindingConstraint> binding_constraints(const FlipProgram& program,
                                                   const PlanModel& model, const PlanGoal& goal,
                                                   const PlanOptions& options,
                                                   const PlannedMotion& plan,
                                                   const std::vector<double>& values);

}  // namespace torquewright::hopper
