// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "src/commands/identification/refined_actuators.hpp"
#include "src/report/identification/robot_report.hpp"

namespace torquewright::cli {

/// Why the rig's robot is not simulated under its own controllers; empty where it is, or where the
/// load is no robot.
std::string not_simulated_sentence(const IdentifyInputs& inputs);

/// Indices of joints with the same hardware, group by group: as the rig says, or joints that were
/// given the same file.
std::vector<std::vector<std::size_t>> alike_joints(const IdentifyInputs& inputs);

/// The robot with the actuators as stated.
identification::RobotModel stated_model(const IdentifyInputs& inputs);

/// Gives controllers whose gain nothing states the one at which a fit of it begins.
void begin_gains(const IdentifyRequest& request, IdentifyInputs& inputs);

/// The robot's values with the gains of its controllers, where such are to be found: what its
/// drives gave is known with them only.
std::optional<identification::RobotStudy> study_of_gains(const IdentifyRequest& request,
                                                         const IdentifyInputs& inputs);

/// Searches by simulation for what the drives lack, beside the study of gains or a study of its
/// own, and lets it judge what the balances of torques named. Nothing where the robot is not
/// simulated, or no value of it could be fitted.
std::optional<identification::RobotStudy> judged_by_simulation(
    const IdentifyRequest& request, const IdentifyInputs& inputs,
    std::optional<identification::RobotStudy> study, identification::Identification& found);

/// Simulates the rig's robot under its own controllers with the actuators as stated, with what the
/// balance of torques found, and with values fitted by simulation on the runs that were not held
/// out. Where these leave the least on the runs that were, they take the place of what was found in
/// `refined`, and the errors are those of the documents read back. Nothing where the rig's load is
/// no robot, or a joint's law is not stated.
std::optional<report::RobotReport> simulated_robot(const IdentifyRequest& request,
                                                   const IdentifyInputs& inputs,
                                                   const identification::Identification& found,
                                                   RefinedActuators& refined,
                                                   std::optional<identification::RobotStudy> study);

}  // namespace torquewright::cli
