// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/planning/result/plan_result.hpp"
#include "hopper/planning/tasks/plan_options.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Whether changes are worth trying: there is no plan, and the search did not lack time.
bool can_be_explained(PlanStatus status);

/// Finds single changes that make a plan: less of each part of the reserve, more voltage, more
/// current, less or more of each moved drive's ratio, less mass; of each the smallest of a short
/// ladder of changes, found by halving the ladder. Every search begins where `options` say. At most
/// `most_seconds` in all, an equal share of what is left for each; options.should_stop ends it.
/// Changes that were not answered are marked. docs/flip.md, "What would have to be otherwise".
std::vector<ChangeTried> changes_that_help(const Robot& robot, const PlanOptions& options,
                                           double most_seconds);

}  // namespace torquewright::hopper
