// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {

/// Rows of which the sum is an objective.
using Costs = std::vector<std::unique_ptr<const optimization::Rows>>;

/// A cost of a law of one row.
template <typename Law>
std::unique_ptr<const optimization::Rows> jet_cost(std::string_view name,
                                                   std::vector<int> variables, Law law) {
  return jet_rows(std::string(name), std::move(variables), {{}}, {1.0}, std::move(law));
}

void add_costs(Costs costs, FlipProgram& program);
double sum_of(const Costs& costs, const std::vector<double>& values);

}  // namespace torquewright::hopper
