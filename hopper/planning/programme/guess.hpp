// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/tasks/plan_goal.hpp"

namespace torquewright::hopper {

/// Interpolates between the instants of a phase, at `share` of its duration: positions cubic by
/// their velocities, velocities cubic by their accelerations, torques and forces straight.
PlannedInstant instant_at(const PlannedPhase& phase, double share);

/// A first guess by key frames: standing_posture() and the document's "takeoff" and "tuck" where it
/// has them, feet where the stances hold them, a hump of the base in flight. No motion: it obeys no
/// equation but those of places.
PlannedMotion key_frame_guess(const PlanModel& model, const std::vector<MeshPhase>& mesh,
                              const PlanGoal& goal, const PlanOptions& options);

}  // namespace torquewright::hopper
