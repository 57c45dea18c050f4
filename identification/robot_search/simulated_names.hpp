// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/findings/result.hpp"
#include "identification/robot_search/simulated_search.hpp"

namespace torquewright::identification {

/// What the equations of each joint name of its drive, for certain or as one of several: where a
/// search by simulation may begin. `joints`: names, in the order of the stated drives.
NamedByJoint named_by_equations(const std::vector<EquationResult>& equations,
                                const std::vector<std::string>& joints, const RobotModel& stated);

/// Lets the simulation of the robot under its own loops judge what balances of torques named: what
/// it does not need is rejected, what it needs and they did not name is named, a group or a doubt
/// that it settles is settled; the base's attitude is one for all joints. Verdicts follow.
void judge_names(const SimulatedSearch& search, const RobotStudy& study,
                 const std::vector<std::string>& joints, std::vector<EquationResult>& equations);

}  // namespace torquewright::identification
