// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/held_bus.hpp"

#include <utility>

#include "actuator/conditions/held_region.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;
using actuator::kUnlimited;

}  // namespace

HeldBus::HeldBus(const Actuator& actuator, const actuator::OperatingConditions& conditions,
                 bool shares_battery)
    : actuator_(actuator),
      conditions_(conditions),
      temperature_K_(winding_temperature_K(actuator, conditions)),
      model_(phase_model_at(actuator, conditions)) {
  conditions_.state_of_charge.reset();
  conditions_.winding_temperature_K = temperature_K_;
  if (shares_battery) {
    actuator_.battery.reset();
  } else {
    actuator_ = without_voltage_sag(std::move(actuator_));
  }
  held_ = phase_model_at(held_at(open_circuit_V()), conditions_);
}

actuator::PhaseModel HeldBus::model_at(double bus_V) const {
  actuator::PhaseModel model = held_;
  model.supply.open_circuit_V = bus_V;
  return model;
}

actuator::JointRange HeldBus::range(double bus_V, double speed_rad_s) const {
  actuator::OperatingConditions conditions = conditions_;
  conditions.bus_voltage_V = bus_V;
  if (!actuator_.battery) return range_at(actuator_, conditions, speed_rad_s);
  return range_at(held_at(bus_V), conditions, speed_rad_s);
}

/// A battery of its own is taken for one without resistance at that voltage, whose limits are the
/// same powers.
Actuator HeldBus::held_at(double bus_V) const {
  Actuator held = actuator_;
  held.drive.bus_voltage_V = bus_V;
  if (!actuator_.battery) return held;
  const actuator::Supply& supply = model_.supply;
  actuator::Battery stiff;
  stiff.cell_open_circuit = {{1.0, bus_V}};
  if (supply.greatest_power_W < kUnlimited) {
    stiff.discharge_limit_A = supply.greatest_power_W / bus_V;
  }
  held.battery = stiff;
  held.drive.regeneration_limit_W = -supply.least_power_W;
  return held;
}

}  // namespace torquewright::hopper
