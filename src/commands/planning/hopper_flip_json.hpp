// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "src/commands/planning/hopper_flip_inputs.hpp"
#include "src/commands/planning/robust_choice.hpp"
#include "src/sweep/swept.hpp"

namespace torquewright::cli {

/// The answer of `hopper flip` as a document of kind plan_report.
std::string hopper_flip_json(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                             const hopper::PlanResult& result,
                             const std::optional<RobustChoice>& robust);

/// A fingerprint of all that a sweep's points depend on beside the robot's values.
std::string hopper_flip_fingerprint(const HopperFlipRequest& request,
                                    const HopperFlipInputs& inputs);
/// The sweep as a document of kind sweep_result.
std::string hopper_flip_sweep_json(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                                   const sweep::Swept& swept);

}  // namespace torquewright::cli
