// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"

namespace torquewright::hopper {

/// Costs that every plan has beside its objectives: of torques that chatter from instant to instant
/// and of joints that accelerate for nothing. Small: what a plan is for decides where that says
/// anything, and these decide where it does not.
void add_smoothness(const PlanModel& model, FlipProgram& program);

}  // namespace torquewright::hopper
