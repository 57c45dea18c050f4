// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/planning/constraints/every_constraint.hpp"

namespace torquewright::hopper {

/// Returns every constraint of the planner, in the order of their rows.
const std::vector<const Constraint*>& every_constraint();

}  // namespace torquewright::hopper
