// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "identification/robot/robot_study.hpp"
#include "identification/rollout/simulated_errors.hpp"
#include "io/documents/document.hpp"

namespace torquewright::identification {

/// The document of one joint's actuator with the values that the robot's motion gave its drive:
/// rotor, and the effects that a fit may move, with their errors. `logs`: for the provenance, which
/// states the joint's error on runs that were held out, in rad, before and after.
nlohmann::ordered_json fitted_actuator(const io::Document& nominal, const RobotStudy& study,
                                       std::size_t joint, const std::vector<Log::File>& logs,
                                       const SimulatedErrors& errors);

}  // namespace torquewright::identification
