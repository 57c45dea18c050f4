// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"

namespace torquewright::hopper {

/// `guess` has as many phases as the mesh.
FlipProgram flip_program(const PlanModel& model, const std::vector<MeshPhase>& mesh,
                         const PlanGoal& goal, const PlanOptions& options,
                         const PlannedMotion& guess);

/// The motion that values of the program's unknowns are.
PlannedMotion motion_of(const FlipProgram& program, const PlanModel& model,
                        const std::vector<double>& values);

}  // namespace torquewright::hopper
