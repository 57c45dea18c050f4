// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "src/commands/planning/hopper_flip_inputs.hpp"
#include "src/commands/planning/robust_choice.hpp"

namespace torquewright::cli {

/// Checks before the work: throws io::SpecError where a file cannot be written or drawn.
void require_flip_outputs(const HopperFlipRequest& request);

/// Throws io::SpecError where a file cannot be written, or is one that has been read.
void check_flip_files(const HopperFlipRequest& request);

/// Writes the files that were asked for, all or none, then stdout. The motion and its pictures are
/// written of a plan alone; that they are not is said on stderr. The motion takes the name of the
/// file that it goes to. `robust`: how its reserve was chosen, if it was.
void write_flip_outputs(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                        hopper::PlanResult& result, const std::optional<RobustChoice>& robust);

}  // namespace torquewright::cli
