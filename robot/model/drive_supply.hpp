// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/region/operating_conditions.hpp"

namespace torquewright::hopper {

/// A battery and the drives that it feeds, or a drive with a supply of its own.
struct DriveSupply {
  std::vector<std::size_t> drives;  ///< Indices.
  actuator::Supply supply;
};

/// Every drive is on one. Drives that state the same battery share it, as in `hopper check`; how
/// much power a drive itself returns is its region's, not the battery's.
std::vector<DriveSupply> drive_supplies(const std::vector<const actuator::Actuator*>& drives,
                                        const actuator::OperatingConditions& conditions);

/// The greatest power that it can give; may be infinite.
double greatest_power_W(const actuator::Supply& supply);

/// The voltage under that power, or under the nearest that the supply gives or takes back.
double loaded_voltage_V(const actuator::Supply& supply, double power_W);

}  // namespace torquewright::hopper
