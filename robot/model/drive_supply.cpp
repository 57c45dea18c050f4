// SPDX-License-Identifier: Apache-2.0
#include "robot/model/drive_supply.hpp"

#include <algorithm>

#include "actuator/conditions/held_region.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;
using actuator::Supply;

/// Of the supply alone: as if the drive took and returned whatever there is.
Supply supply_of(Actuator actuator, const actuator::OperatingConditions& conditions) {
  actuator.drive.supply_current_A = actuator::kUnlimited;
  actuator.drive.regeneration = true;
  actuator.drive.regeneration_limit_W = actuator::kUnlimited;
  return phase_model_at(actuator, conditions).supply;
}

double own_line_ohm(Actuator actuator, const actuator::OperatingConditions& conditions) {
  actuator.battery.reset();
  return phase_model_at(actuator, {conditions.rating, {}, {}, {}}).supply.resistance_ohm;
}

/// The battery that several drives share, and what lies between it and each.
void share(const std::vector<const Actuator*>& drives,
           const actuator::OperatingConditions& conditions, DriveSupply& supply) {
  supply.supply =
      supply_of(actuator::without_voltage_sag(*drives[supply.drives.front()]), conditions);
  for (std::size_t i = 0; i < supply.drives.size(); ++i) {
    supply.lines_ohm[i] = own_line_ohm(*drives[supply.drives[i]], conditions);
  }
}

}  // namespace

bool has_own_line(const DriveSupply& supply) { return supply.drives.size() > 1; }

double drawn_power_W(double battery_V, double line_ohm, double power_W) {
  if (line_ohm == 0.0) return power_W;
  Supply line;
  line.open_circuit_V = battery_V;
  line.resistance_ohm = line_ohm;
  const double drive_V = actuator::bus_voltage_V(line, power_W).value_or(0.5 * battery_V);
  return power_W * battery_V / drive_V;
}

std::vector<DriveSupply> drive_supplies(const std::vector<const Actuator*>& drives,
                                        const actuator::OperatingConditions& conditions) {
  std::vector<DriveSupply> supplies;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const auto same = std::find_if(supplies.begin(), supplies.end(), [&](const DriveSupply& one) {
      return drives[i]->battery && drives[one.drives.front()]->battery == drives[i]->battery;
    });
    if (same != supplies.end()) {
      same->drives.push_back(i);
      same->lines_ohm.push_back(0.0);
    } else {
      supplies.push_back({{i}, supply_of(*drives[i], conditions), {0.0}});
    }
  }
  for (DriveSupply& supply : supplies) {
    if (has_own_line(supply)) share(drives, conditions, supply);
  }
  return supplies;
}

double greatest_power_W(const Supply& supply) {
  if (supply.resistance_ohm <= 0.0) return supply.greatest_power_W;
  const double open_V = supply.open_circuit_V;
  return std::min(supply.greatest_power_W, open_V * open_V / (4.0 * supply.resistance_ohm));
}

double loaded_voltage_V(const Supply& supply, double power_W) {
  const double given_W =
      std::min(std::max(power_W, supply.least_power_W), greatest_power_W(supply));
  // At the greatest power the root may be rounded away: there half the open circuit is left.
  return actuator::bus_voltage_V(supply, given_W).value_or(0.5 * supply.open_circuit_V);
}

}  // namespace torquewright::hopper
