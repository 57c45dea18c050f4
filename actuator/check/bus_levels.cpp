// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/bus_levels.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator {
namespace {

constexpr double kStepRoundOff = 1e-9;  // of a step

}  // namespace

BusLevels::Level::Level(Actuator held, const OperatingConditions& conditions)
    : actuator(std::move(held)), basis(actuator, conditions) {}

BusLevels::BusLevels(const Actuator& actuator, const OperatingConditions& conditions)
    : actuator_(actuator),
      conditions_(conditions),
      step_V_(kStep * open_circuit_voltage_V(actuator, conditions)) {
  actuator_.battery.reset();
  conditions_.bus_voltage_V.reset();
  conditions_.state_of_charge.reset();
}

const CheckBasis& BusLevels::at(double bus_voltage_V) {
  const int level =
      std::max(1, static_cast<int>(std::floor(bus_voltage_V / step_V_ + kStepRoundOff)));
  std::unique_ptr<Level>& found = levels_[level];
  if (!found) {
    actuator_.drive.bus_voltage_V = level * step_V_;
    found = std::make_unique<Level>(actuator_, conditions_);
  }
  return found->basis;
}

}  // namespace torquewright::actuator
