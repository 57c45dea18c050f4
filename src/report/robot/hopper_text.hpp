// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/candidates/candidates.hpp"

namespace torquewright::report {

/// The verdict, and the motion as a whole.
std::string motion_text(const hopper::Robot& robot, const hopper::Motion& motion,
                        const hopper::HopperReport& report);

/// All that `hopper check` can say: the verdict, the motion as a whole, each drive, the findings of
/// that severity and worse ones.
std::string hopper_text(const hopper::Robot& robot, const hopper::Motion& motion,
                        const hopper::HopperReport& report,
                        actuator::Severity least = actuator::Severity::kNote);

/// A table a drivetrain: who passes, by margin, and why the others do not.
std::string candidates_text(const hopper::Robot& robot,
                            const std::vector<hopper::CandidateResult>& results);

}  // namespace torquewright::report
