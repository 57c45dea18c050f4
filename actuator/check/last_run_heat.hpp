// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/check/drive_check.hpp"

namespace torquewright::actuator {

/// A drive's conditions with its winding as cold and as warm as it is in the last of several runs.
struct LastRunHeat {
  OperatingConditions coldest;
  OperatingConditions warmest;
};

/// Empty where that is nothing else than what was asked for: of a single run, which begins cold, of
/// a drive whose winding's temperature was stated or is not known, and of one that stays as cold as
/// its region.
std::optional<LastRunHeat> last_run_heat(const CheckedDrive& drive, const DriveReport& report);

/// Of a drive that passes as asked for, and fails at the warmest of its last run: whether it fails
/// or is open, by its verdict at the coldest.
void hold_warm(const LastRunHeat& heat, Verdict at_coldest, DriveReport& warmest);

}  // namespace torquewright::actuator
