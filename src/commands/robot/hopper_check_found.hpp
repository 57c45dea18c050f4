// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/candidates/candidates.hpp"
#include "hopper/check/hopper_check.hpp"
#include "hopper/motion/motion.hpp"

namespace torquewright::cli {

/// What a whole-body check found.
struct HopperCheckFound {
  hopper::Motion motion;  ///< With the rates that it lacked.
  hopper::HopperReport report;
  std::vector<hopper::CandidateResult> candidates;  ///< Empty where no folder of them was given.
};

}  // namespace torquewright::cli
