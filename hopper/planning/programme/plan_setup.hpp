// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/tasks/plan_goal.hpp"

namespace torquewright::hopper {

/// The phases of a plan before it is cut more finely: how long each may take, and intervals enough
/// for `options.intervals` in all, more where contacts change.
std::vector<MeshPhase> first_mesh(const std::vector<Stance>& stances, const PlanOptions& options);

/// What the options' task asks for. Standing is standing_posture() of the document, the joint
/// that balances it left open; without one, joints within the middle half of their ranges. A foot
/// of one point stands at any pitch, the base level. io::SpecError where it cannot stand like that.
PlanGoal plan_goal(const PlanModel& model, const PlanOptions& options);

/// The stances that the options name, or their task's on such a foot.
std::vector<Stance> plan_stances(const SagittalRobot& plane, const PlanOptions& options);

}  // namespace torquewright::hopper
