// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/drive_check/drive_check.hpp"
#include "actuator/drive_check/report.hpp"

namespace torquewright::actuator {

/// Returns a note for each battery that the actuators of several joints state alike: every joint
/// was checked as if it had that battery alone.
std::vector<Finding> shared_battery_findings(const std::vector<CheckedDrive>& drives);

}  // namespace torquewright::actuator
