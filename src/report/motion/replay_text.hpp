// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/replay_report/replay_report.hpp"

namespace torquewright::report {

/// What `hopper replay` says: how it ended, each drive, the findings, and how much of it is the
/// step's doing. Findings of that severity and worse ones.
std::string replay_text(const hopper::Robot& robot, const hopper::Motion& motion,
                        const hopper::ReplayReport& report,
                        actuator::Severity least = actuator::Severity::kNote);

}  // namespace torquewright::report
