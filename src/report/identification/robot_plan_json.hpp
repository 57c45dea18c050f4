// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "identification/robot_plan/robot_plan.hpp"

namespace torquewright::report {

/// A robot's plan as a document without its provenance ("tool", "inputs"). `options`: what the
/// command was asked.
nlohmann::ordered_json robot_plan_json(const identification::RobotPlan& plan,
                                       const identification::RobotPlanOptions& options,
                                       const std::vector<std::string>& joints,
                                       nlohmann::ordered_json stated);

}  // namespace torquewright::report
