// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/search/plan.hpp"
#include "src/sweep/swept.hpp"

namespace torquewright::cli {

/// What a sweep keeps of a search for a plan; docs/sweeps.md lists the measures, which are of plans
/// alone: of what is none they would be a motion's that the robot cannot do.
sweep::SweepRow hopper_flip_row(const hopper::Robot& robot, const hopper::CheckOptions& check,
                                const hopper::PlanResult& result);

}  // namespace torquewright::cli
