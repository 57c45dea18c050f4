// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/motion.hpp"
#include "hopper/planning/model/plan_model.hpp"

namespace torquewright::hopper {

/// A motion of this robot as a guess: its phases by which contact points touch, its torques and
/// forces left open. io::SpecError, in the name of `file`, where it leaves the plane, has no base,
/// or touches the ground in another order than the stances ask for.
PlannedMotion warm_guess(const Robot& robot, const PlanModel& model,
                         const std::vector<Stance>& stances, const Motion& motion,
                         const ContactRule& contact, const std::string& file);

}  // namespace torquewright::hopper
