// SPDX-License-Identifier: Apache-2.0
#include "identification/balance.hpp"

#include <cmath>

#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "actuator/region/winding.hpp"

namespace torquewright::identification {
namespace {

constexpr int kFactorRounds = 8;  ///< A contraction for any saturation short of its limit.

}  // namespace

Balance::Balance(const Bench& bench)
    : bench_(bench),
      is_sensor_(bench.load_side == LoadSide::kSensor),
      torque_per_ampere_Nm_A_(bench.actuator().transmission.ratio *
                              bench.actuator().motor.torque_constant_Nm_A),
      reflected_inertia_kg_m2_(actuator::reflected_inertia_kg_m2(bench.actuator())) {}

double Balance::needed_Nm(const Signals& signals, std::size_t i) const {
  const actuator::Actuator& actuator = bench_.actuator();
  const actuator::Instant& at = signals.at[i];
  return actuator::before_mesh_Nm(actuator, signals.load_side_Nm[i], at.direction) +
         reflected_inertia_kg_m2_ * at.acceleration_rad_s2 - actuator::drag_Nm(actuator, at) -
         actuator::periodic_motor_torque_Nm(actuator, at);
}

double Balance::predicted_Nm(const Signals& signals, std::size_t i) const {
  if (is_sensor_) return actuator::output_torque_Nm(bench_.actuator(), signals.at[i]);
  // The current that the needed torque asks for, with every effect on the torque constant.
  const double needed = needed_Nm(signals, i);
  double stated = needed;
  for (int round = 0; round < kFactorRounds; ++round) {
    actuator::Instant at = signals.at[i];
    at.current_A = stated / torque_per_ampere_Nm_A_;
    const double factor =
        at.current_A == 0.0 ? 1.0 : actuator::motor_torque_Nm(bench_.actuator(), at) / stated;
    const double next = factor > 0.0 ? needed / factor : stated;
    if (next == stated) break;
    stated = next;
  }
  return stated;
}

double Balance::measured_Nm(const Signals& signals, std::size_t i) const {
  return is_sensor_ ? signals.load_side_Nm[i] : signals.motor_side_Nm[i];
}

double Balance::residual_Nm(const Signals& signals, std::size_t i) const {
  const double over = measured_Nm(signals, i) - predicted_Nm(signals, i);
  return is_sensor_ ? over : -over;
}

double Balance::gain(const Signals& signals, std::size_t i) const {
  if (!is_sensor_) return 1.0;
  const actuator::Instant& at = signals.at[i];
  const double sign = actuator::before_mesh_at_Nm(bench_.actuator(), at) < 0.0 ? -1.0 : 1.0;
  return sign * actuator::after_mesh_Nm(bench_.actuator(), sign, at.direction);
}

double Balance::driven_Nm(const Signals& signals, std::size_t i) const {
  return is_sensor_ ? signals.motor_side_Nm[i] : needed_Nm(signals, i);
}

double Balance::of_torque_constant_Nm(const Signals& signals, std::size_t i) const {
  const double torque_Nm = gain(signals, i) * driven_Nm(signals, i);
  const actuator::Actuator& actuator = bench_.actuator();
  if (bench_.drive != Drive::kVoltage || actuator.motor.back_emf_constant_V_s_rad) return torque_Nm;
  // The torque that the back-EMF keeps from being, N Kt Ke N w / R.
  const actuator::Winding winding = actuator::winding_of(actuator);
  const double ratio = actuator.transmission.ratio;
  const double per_speed = ratio * actuator.motor.torque_constant_Nm_A * ratio *
                           winding.back_emf_V_s_rad / winding.resistance_ohm;
  return torque_Nm - gain(signals, i) * per_speed * signals.at[i].speed_rad_s;
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
