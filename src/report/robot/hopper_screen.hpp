// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/check/hopper_check.hpp"

namespace torquewright::report {

/// What `hopper check` says on one screen: the verdict, the motion as a whole, a line a drive, the
/// findings that weigh most and how many more there are; or all of that severity and worse ones,
/// where it is not that of notes.
std::string hopper_screen(const hopper::Robot& robot, const hopper::Motion& motion,
                          const hopper::HopperReport& report,
                          actuator::Severity least = actuator::Severity::kNote);

}  // namespace torquewright::report
