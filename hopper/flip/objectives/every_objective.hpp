// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hopper/flip/plan_model.hpp"
#include "hopper/flip/plan_variables.hpp"

namespace torquewright::hopper {

using Costs = std::vector<std::unique_ptr<const optimization::Rows>>;

/// The costs of a plan's objectives, weighted.
Costs objective_rows(const PlanModel& model, const PlanOptions& options, FlipProgram& program);

}  // namespace torquewright::hopper
