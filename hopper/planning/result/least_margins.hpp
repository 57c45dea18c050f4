// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/hopper_check.hpp"
#include "hopper/planning/result/plan_result.hpp"

namespace torquewright::hopper {

/// How far a checked motion is from each rule's limit at least; the least share of the limit first.
std::vector<LeastMargin> least_margins(const Robot& robot, const Motion& motion,
                                       const HopperReport& report);

}  // namespace torquewright::hopper
