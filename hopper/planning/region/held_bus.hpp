// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/region/joint_region.hpp"

namespace torquewright::hopper {

/// An actuator's region with the bus held at a voltage, as `hopper check` judges by it while
/// something else (all drives together, or the drive itself) settles that voltage.
class HeldBus {
 public:
  /// Requires that there are no objections. `shares_battery`: others load the same battery; then a
  /// voltage_sag of the actuator's own comes on top of the bus's, and the battery's limits of power
  /// are the bus's, not the drive's (actuator::HeldRegion).
  HeldBus(const actuator::Actuator& actuator, const actuator::OperatingConditions& conditions,
          bool shares_battery);

  /// Voltage of the bus without load, in these conditions.
  double open_circuit_V() const { return model_.supply.open_circuit_V; }

  /// The electrical side in the conditions, behind its own supply.
  const actuator::PhaseModel& model() const { return model_; }

  /// The electrical side while the bus is held.
  actuator::PhaseModel model_at(double bus_V) const;

  /// Range of torques at the joint.
  actuator::JointRange range(double bus_V, double speed_rad_s) const;

  const actuator::Actuator& actuator() const { return actuator_; }
  double temperature_K() const { return temperature_K_; }

 private:
  actuator::Actuator held_at(double bus_V) const;

  actuator::Actuator actuator_;
  actuator::OperatingConditions conditions_;
  double temperature_K_;
  actuator::PhaseModel model_;
  actuator::PhaseModel held_;
};

}  // namespace torquewright::hopper
