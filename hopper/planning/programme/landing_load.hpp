// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"

namespace torquewright::hopper {

/// Rows that hold what passes each drive's gears in the windows after and before a phase's impact
/// to PlanModel::gear_Nm: the size of the mean torque over the window and that of the rotor's
/// impulse spread over it, as `hopper check` adds them (docs/derivations/whole_body_check.md eq.
/// (12)). The windows reach over the instants that they cover at the guess's durations of the
/// phases; those that lie on both sides of the impact are between. Drives without a limit get no
/// rows.
void add_landing_load(const PlanModel& model, double window_s, std::size_t phase,
                      FlipProgram& program);

}  // namespace torquewright::hopper
