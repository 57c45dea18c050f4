// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"

namespace torquewright::hopper {

/// A plan as a nonlinear program: unknowns on the mesh, the rows of every constraint
/// (hopper/planning/constraints), the costs of the options' objectives and of smoothness. `guess`
/// has as many phases as the mesh.
FlipProgram flip_program(const PlanModel& model, const std::vector<MeshPhase>& mesh,
                         const PlanGoal& goal, const PlanOptions& options,
                         const PlannedMotion& guess);

}  // namespace torquewright::hopper
