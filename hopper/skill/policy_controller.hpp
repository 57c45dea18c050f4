// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "hopper/skill/skill.hpp"
#include "hopper/tracking/controller_kind.hpp"
#include "learning/network/policy.hpp"

namespace torquewright::hopper {

/// The kind of what policy_controller() makes, for reports; it prepares none itself.
extern const ControllerKind policy_kind;

/// Makes a policy ready as a controller of a robot: every control period of the skill it is asked
/// for an action, between two of them the PD law acts at every look. It feeds nothing forward. The
/// robot must outlive it. Requires a policy with as many inputs and outputs as the skill.
std::unique_ptr<const ReadyController> policy_controller(const Robot& robot, const Skill& skill,
                                                         const learning::Policy& policy,
                                                         const Command& command);

}  // namespace torquewright::hopper
