// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Compares positions with velocities, and angles with a turn. Throws io::SpecError, with what to
/// write into the rig, for degrees, degrees per second or rpm under names in radians, and for a
/// position and a velocity of opposite signs; what is only suspected becomes a finding.
void check_motion(Log& log, const Rig& rig);

}  // namespace torquewright::identification
