// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/result/plan_result.hpp"
#include "hopper/planning/tasks/plan_options.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// plan_motion() (plan.hpp) without looking for what would have to be otherwise.
PlanResult search_plan(const Robot& robot, const PlanOptions& options);

}  // namespace torquewright::hopper
