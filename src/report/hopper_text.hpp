// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/check/hopper_check.hpp"

namespace torquewright::report {

/// What `hopper check` says: the verdict, the motion as a whole, each drive, the findings.
std::string hopper_text(const hopper::Robot& robot, const hopper::Motion& motion,
                        const hopper::HopperReport& report);

}  // namespace torquewright::report
