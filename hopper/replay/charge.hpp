// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/record/record.hpp"
#include "hopper/replay/result.hpp"

namespace torquewright::hopper {

/// Adds what a run took out of each battery whose cells state a capacity, by the rule of `hopper
/// check`. What took more than there was in one has not done what it did: it is missed.
void judge_charge(const Robot& robot, const actuator::OperatingConditions& conditions,
                  const Record& record, ReplayResult& result);

}  // namespace torquewright::hopper
