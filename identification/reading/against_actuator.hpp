// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Checks what only the nominal actuators (one per joint, in the order of Rig::joints) can tell: a
/// current in mA, angles in degrees on both of position and velocity, signs of motor and torque.
/// Adds findings, or throws io::SpecError with what to write into the rig. Where a check rests on a
/// constant that the rig calls uncertain it only warns.
void check_against(Log& log, const Rig& rig, const std::vector<actuator::Actuator>& actuators);

}  // namespace torquewright::identification
