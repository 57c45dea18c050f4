// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/tasks/plan_goal.hpp"

namespace torquewright::hopper {

/// The joint, of those that move, that is turned until a posture stands: next to the foot, which
/// lies flat, or, over a foot of one point, next to the base, which is level.
std::size_t balancing_joint(const SagittalRobot& plane);

/// The pitch at which the foot stands under joints (k x 1): 0, or on one point what keeps the base
/// level.
double standing_foot_rad(const SagittalRobot& plane, const Eigen::VectorXd& joint_rad);

/// The posture (k x 1) with the balancing joint where in its range the mass is nearest to the
/// middle of the sole.
Eigen::VectorXd balanced(const PlanModel& model, Eigen::VectorXd joint_rad);

/// io::SpecError where no posture that the goal lets it stand in is within the joints' reach, or
/// where none of them has its mass over the middle of the sole.
void require_standing(const PlanModel& model, const PlanGoal& goal);

}  // namespace torquewright::hopper
