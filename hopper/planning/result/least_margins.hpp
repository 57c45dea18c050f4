// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/hopper_check.hpp"
#include "hopper/planning/result/plan_result.hpp"

namespace torquewright::hopper {

/// Returns the least distance of a checked motion from each rule's limit; the least share of the
/// limit comes first.
std::vector<LeastMargin> least_margins(const Robot& robot, const Motion& motion,
                                       const HopperReport& report);

}  // namespace torquewright::hopper
