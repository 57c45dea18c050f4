// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/last_run_heat.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator {
namespace {

/// At that temperature, or as asked for where the document's laws do not reach there.
OperatingConditions at_winding_K(const CheckedDrive& drive, double temperature_K) {
  OperatingConditions conditions = drive.conditions;
  conditions.winding_temperature_K = temperature_K;
  return objections(*drive.actuator, conditions).empty() ? conditions : drive.conditions;
}

}  // namespace

std::optional<LastRunHeat> last_run_heat(const CheckedDrive& drive, const DriveReport& report) {
  const std::optional<WindingReport>& winding = report.interpretation.winding;
  if (!winding || winding->runs < 2 || drive.conditions.winding_temperature_K) return std::nullopt;
  const double asked_K = winding_temperature_K(*drive.actuator, drive.conditions);
  if (!std::isfinite(winding->peak_K) || winding->peak_K < asked_K + kSteady_K) return std::nullopt;
  LastRunHeat heat{at_winding_K(drive, std::max(asked_K, winding->coldest_K)),
                   at_winding_K(drive, winding->peak_K)};
  if (!heat.warmest.winding_temperature_K) return std::nullopt;
  return heat;
}

void hold_warm(const LastRunHeat& heat, Verdict at_coldest, DriveReport& warmest) {
  if (at_coldest != Verdict::kFail) warmest.verdict = Verdict::kUndecided;
  warmest.held_warm_K = heat.warmest.winding_temperature_K;
}

}  // namespace torquewright::actuator
