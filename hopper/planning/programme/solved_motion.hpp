// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"

namespace torquewright::hopper {

/// The motion that values of the program's unknowns are.
PlannedMotion motion_of(const FlipProgram& program, const PlanModel& model,
                        const std::vector<double>& values);

}  // namespace torquewright::hopper
