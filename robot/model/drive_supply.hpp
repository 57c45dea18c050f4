// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/region/operating_conditions.hpp"

namespace torquewright::hopper {

/// A battery and the drives that it feeds, or a drive with a supply of its own.
struct DriveSupply {
  std::vector<std::size_t> drives;  ///< Indices.
  actuator::Supply supply;
  /// Of drives that share a battery what lies between it and each of them (voltage_sag), in the
  /// order of `drives`; 0 of a drive with a supply of its own, which has it in the supply.
  std::vector<double> lines_ohm;
};

/// Whether a drive's voltage_sag lies in a line of its own, behind a battery that others load too.
bool has_own_line(const DriveSupply& supply);

/// What flows out of the battery at that voltage where a drive takes the power behind its line.
double drawn_power_W(double battery_V, double line_ohm, double power_W);

/// Every drive is on one. Drives that state the same battery share it, as in `hopper check`; how
/// much power a drive itself returns is its region's, not the battery's.
std::vector<DriveSupply> drive_supplies(const std::vector<const actuator::Actuator*>& drives,
                                        const actuator::OperatingConditions& conditions);

/// The greatest power that it can give; may be infinite.
double greatest_power_W(const actuator::Supply& supply);

/// The voltage under that power, or under the nearest that the supply gives or takes back.
double loaded_voltage_V(const actuator::Supply& supply, double power_W);

}  // namespace torquewright::hopper
