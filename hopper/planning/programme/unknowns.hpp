// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"

namespace torquewright::hopper {

/// Adds a plan's unknowns, phase by phase, where the guess has them and within what stances, limits
/// and the goal let them be. Requires the program's mesh, and a guess of as many phases.
void add_unknowns(const PlanModel& model, const PlanGoal& goal, const PlannedMotion& guess,
                  FlipProgram& program);

}  // namespace torquewright::hopper
