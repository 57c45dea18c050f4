// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/commands/robot/hopper_check_found.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"
#include "src/sweep/swept.hpp"

namespace torquewright::cli {

/// The report as a document of kind check_report.
std::string hopper_check_json(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                              const HopperCheckFound& found);

/// SHA-256 of all that a check depends on beside the robot's swept values.
std::string hopper_check_fingerprint(const HopperCheckRequest& request,
                                     const HopperCheckInputs& inputs, const hopper::Motion& motion);

/// A sweep of checks as a document of kind sweep_result.
std::string hopper_check_sweep_json(const HopperCheckRequest& request,
                                    const HopperCheckInputs& inputs, const hopper::Motion& motion,
                                    const sweep::Swept& swept);

}  // namespace torquewright::cli
