// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/planning/objectives/objective.hpp"

namespace torquewright::hopper {

const std::vector<Objective>& every_objective();
std::vector<std::string> objective_names();
/// Returns the objective of that name. io::SpecError, with the nearest name and all known ones,
/// where there is none.
const Objective& objective_named(std::string_view name);

/// Returns the objectives of the options; effort, where they name none.
std::vector<WeightedObjective> objectives_of(const PlanOptions& options);

}  // namespace torquewright::hopper
