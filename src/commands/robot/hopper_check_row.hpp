// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/hopper_check.hpp"
#include "src/sweep/swept.hpp"

namespace torquewright::cli {

/// What a sweep keeps of a whole-body check; docs/sweeps.md lists the measures.
sweep::SweepRow hopper_check_row(const hopper::Robot& robot, const hopper::CheckOptions& options,
                                 const hopper::HopperReport& report);

}  // namespace torquewright::cli
