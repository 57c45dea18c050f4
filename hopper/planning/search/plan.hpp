// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/result/plan_result.hpp"
#include "hopper/planning/tasks/plan_options.hpp"

namespace torquewright::hopper {

/// Plans a motion in the sagittal plane by direct collocation; docs/derivations/collocation.md.
/// Throws io::SpecError where robot or options cannot be planned with at all: a robot that is not
/// symmetric about the plane or cannot stand, no gravity, a warm motion of another robot.
PlanResult plan_motion(const Robot& robot, const PlanOptions& options);

}  // namespace torquewright::hopper
