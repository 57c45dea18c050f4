// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/robot_plan/robot_plan.hpp"

namespace torquewright::report {

/// A value's name at its joint: "knee rotor_inertia_kg_m2".
std::string planned_name(const identification::FreeValue& which,
                         const std::vector<std::string>& joints);

/// What `identify plan` says of a robot: each value's expected error beside a sweep's, and how much
/// room the motion leaves to what limits it. `is_long`: all values, not only those that are not
/// told.
std::string robot_plan_text(const identification::RobotPlan& plan,
                            const identification::RobotPlanOptions& options,
                            const std::vector<std::string>& joints, bool is_long);

}  // namespace torquewright::report
