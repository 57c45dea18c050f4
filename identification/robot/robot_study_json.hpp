// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "identification/robot/robot_study.hpp"

namespace torquewright::identification {

/// Adds to a report of identification what a robot's motion says: the fitted values to "simulated",
/// "alike", and errors of its bodies to "load". `joints`: names, in the rig's order.
void add_study(const RobotStudy& study, const std::vector<std::string>& joints,
               nlohmann::ordered_json& report);

/// "RL_calf_joint: dry_friction_Nm at -2.27 rad is 1.94 ± 0.03, its sisters have 0.69 to 1.25:
/// it differs from them by 12 standard errors."
std::string sentence_of(const AlikeNumber& number, const UnlikeJoint& unlike,
                        const std::vector<std::string>& joints);

/// That the base moves, and by what it is seen; empty where it does not.
std::string sentence_of(const BaseMotion& motion);

}  // namespace torquewright::identification
