// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/drive_check/report.hpp"
#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

actuator::LongestStep longest_step(const Motion& motion);

/// Throws io::SpecError with place and length where rates are differentiated across a step so long
/// that the motion in it is unknown (actuator::hides_motion).
void require_seen_rates(const Motion& motion);

}  // namespace torquewright::hopper
