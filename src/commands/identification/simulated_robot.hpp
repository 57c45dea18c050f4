// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "identification/rollout/simulated_errors.hpp"
#include "src/commands/identification/refined_actuators.hpp"

namespace torquewright::cli {

/// Simulates the rig's robot under its own controllers with the actuators as stated, and as refined
/// where any was. None where the rig's load is no robot, or a joint's law is not stated.
std::optional<identification::SimulatedErrors> simulated_errors(const IdentifyRequest& request,
                                                                const IdentifyInputs& inputs,
                                                                const RefinedActuators& refined);

}  // namespace torquewright::cli
