// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/planning/region/held_bus.hpp"

namespace torquewright::hopper {

/// The region of a drive without losses, inductance and saturation: |torque| <= both and
/// |torque + per_speed w| <= per_volt V, everything at the joint.
struct LinearRegion {
  double current_Nm = 0.0;  ///< By current,
  double gear_Nm = 0.0;     ///< and by the gear, which may carry anything.
  double per_speed_Nm_s_rad = 0.0;
  double per_volt_Nm_V = 0.0;
};

/// Empty unless the region at the joint is that within kLinear of its greatest torque, at bus
/// voltages from kLeastVoltage to kGreatestVoltage times the open circuit's and at all speeds.
std::optional<LinearRegion> linear_region(const HeldBus& bus);
constexpr double kLinear = 1e-6;
constexpr double kLeastVoltage = 0.4;  ///< What a plan may look at, margin and all.
constexpr double kGreatestVoltage = 1.3;

}  // namespace torquewright::hopper
