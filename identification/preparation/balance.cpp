// SPDX-License-Identifier: Apache-2.0
#include "identification/preparation/balance.hpp"

#include <cmath>

#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "actuator/region/winding.hpp"

namespace torquewright::identification {

Balance::Balance(const Bench& bench)
    : bench_(bench), is_sensor_(bench.load_side == LoadSide::kSensor) {}

double Balance::gain(const Signals& signals, std::size_t i) const {
  if (!is_sensor_) return 1.0;
  const actuator::Instant& at = signals.at[i];
  const double sign = actuator::before_mesh_at_Nm(bench_.actuator(), at) < 0.0 ? -1.0 : 1.0;
  return sign * actuator::after_mesh_Nm(bench_.actuator(), sign, at.direction);
}

double Balance::unit_per_Nm() const {
  if (is_sensor_ || bench_.drive == Drive::kTorque) return 1.0;
  const actuator::Actuator& actuator = bench_.actuator();
  const double amperes =
      1.0 / std::abs(actuator.transmission.ratio * actuator.motor.torque_constant_Nm_A);
  if (bench_.drive == Drive::kCurrent) return amperes;
  return amperes * actuator::winding_of(actuator).resistance_ohm;
}

Quantity Balance::quantity() const {
  if (is_sensor_) return bench_.load_channel;
  if (bench_.drive == Drive::kVoltage) return Quantity::kWindingVoltage;
  return bench_.drive_channel;
}

}  // namespace torquewright::identification
