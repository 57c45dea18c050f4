// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/commands/hopper_flip_inputs.hpp"

namespace torquewright::cli {

/// The answer of `hopper flip` as a document of kind plan_report.
std::string hopper_flip_json(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                             const hopper::PlanResult& result);

}  // namespace torquewright::cli
