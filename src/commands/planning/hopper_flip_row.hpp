// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/planning/search/plan.hpp"
#include "hopper/trials/explanation.hpp"
#include "src/sweep/swept.hpp"

namespace torquewright::cli {

/// What a sweep keeps of a search for a plan; docs/sweeps.md lists the measures, which are of plans
/// alone: of what is none they would be a motion's that the robot cannot do.
sweep::SweepRow hopper_flip_row(const hopper::Robot& robot, const hopper::CheckOptions& check,
                                const hopper::PlanResult& result);

/// Adds to a row what became of its plan's trials, the share of successes first; none where there
/// is no plan.
void add_trials(const std::optional<hopper::TrialOutcomes>& outcomes, sweep::SweepRow& row);

}  // namespace torquewright::cli
