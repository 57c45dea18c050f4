// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/motor/phase_model.hpp"
#include "actuator/unlimited.hpp"

namespace torquewright::actuator {

/// Where the voltage ends the torques at a speed, by Newton's method in the plane of currents.
/// docs/derivations/motor_region.md eq. (13) to (15).
struct VoltageEnd {
  Current current;
  double torque_Nm = 0.0;
};

/// The end in the direction of `cap`, the current of the greatest torque that way, which the
/// voltage does not allow. Empty where no point was found that meets the conditions of an optimum:
/// the region may have ended before, or be ended by something else. Requires speed >= 0.
std::optional<VoltageEnd> voltage_end(const PhaseModel& model, double speed_rad_s,
                                      const Current& cap);

/// The greatest voltage margin that field weakening leaves within the limits of (8) where the
/// current of a short circuit is beyond them, so that it lies on them; else infinity. Where it is
/// negative there is no torque, and the limiter says why. Requires speed >= 0.
struct GreatestMargin {
  double V = kUnlimited;
  Limiter limiter = Limiter::kFieldWeakening;
};
GreatestMargin greatest_margin(const PhaseModel& model, double speed_rad_s);

}  // namespace torquewright::actuator
