// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/commands/robot/hopper_check_found.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"

namespace torquewright::cli {

/// Checks before the work: throws io::SpecError where a file cannot be written or drawn.
void require_outputs(const HopperCheckRequest& request);

/// Throws io::SpecError where a file cannot be written, or is one that has been read.
void check_output_files(const HopperCheckRequest& request);

/// Writes the files that were asked for, all or none, then stdout. A picture that the motion holds
/// nothing for is left out, which is said on stderr.
void write_outputs(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                   const HopperCheckFound& found);

}  // namespace torquewright::cli
