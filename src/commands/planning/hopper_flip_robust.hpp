// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "src/commands/planning/hopper_flip_inputs.hpp"
#include "src/commands/planning/robust_choice.hpp"

namespace torquewright::cli {

/// `hopper flip --robust FILE`: plans with reserves from --reserve on, replays each in trials, and
/// leaves the chosen plan in `result` and its reserve in `inputs`; of no plan at all the least
/// reserve's answer. Throws io::SpecError as a sweep with trials does.
RobustChoice plan_robustly(const HopperFlipRequest& request, HopperFlipInputs& inputs,
                           hopper::PlanResult& result);

/// A line per reserve, and what fresh draws say.
std::string robust_lines(const HopperFlipRequest& request, const RobustChoice& robust);

}  // namespace torquewright::cli
