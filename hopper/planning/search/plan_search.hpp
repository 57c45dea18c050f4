// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/result/plan_result.hpp"
#include "hopper/planning/tasks/plan_options.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Searches as plan_motion() (plan.hpp) does, without looking for changes that would help.
PlanResult search_plan(const Robot& robot, const PlanOptions& options);

}  // namespace torquewright::hopper
