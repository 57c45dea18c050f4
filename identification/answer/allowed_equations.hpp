// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Says in a finding of every joint why its torque balance cannot be compared, where it cannot.
/// Throws io::SpecError where a joint's motion is not logged, or where no joint's channels allow
/// any equation, with what each of them lacks.
void check_equations(Log& log, const Rig& rig);

}  // namespace torquewright::identification
