// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>

#include "actuator/check/interpretation_check.hpp"

namespace torquewright::actuator {

/// The regions of one actuator at the bus voltages that it meets while others load the same
/// battery.
class BusLevels {
 public:
  /// Distance between two levels over the open-circuit voltage; each level's region is made once.
  static constexpr double kStep = 1e-3;

  /// Requires no objections to the conditions, whose own voltage is the open circuit's.
  BusLevels(const Actuator& actuator, const OperatingConditions& conditions);

  /// Returns the region at the level at or next below that voltage, with the bus held there: by at
  /// most a step too small, never too large.
  const CheckBasis& at(double bus_voltage_V);

 private:
  struct Level {
    Level(Actuator held, const OperatingConditions& conditions);
    Actuator actuator;
    CheckBasis basis;
  };
  Actuator actuator_;
  OperatingConditions conditions_;
  double step_V_;
  std::map<int, std::unique_ptr<Level>> levels_;
};

}  // namespace torquewright::actuator
