// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/candidates/candidates.hpp"
#include "src/commands/hopper_check_inputs.hpp"
#include "src/options/hopper_check_request.hpp"

namespace torquewright::cli {

/// What a whole-body check found.
struct HopperCheckFound {
  hopper::HopperReport report;
  std::vector<hopper::CandidateResult> candidates;  ///< Empty where no folder of them was given.
};

/// For before the work: throws io::SpecError where a file cannot be written or drawn.
void require_outputs(const HopperCheckRequest& request);

/// Writes the files that were asked for, all or none, then stdout. A picture that the motion holds
/// nothing for is left out, which is said on stderr.
void write_outputs(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                   const HopperCheckFound& found);

}  // namespace torquewright::cli
