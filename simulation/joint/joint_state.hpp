// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "actuator/effects/effect.hpp"
#include "actuator/heat/heat_model.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "simulation/excitation.hpp"

namespace torquewright::simulation {

/// State of one joint. Motor quantities are referred to the output.
struct JointState {
  double position_rad = 0.0, speed_rad_s = 0.0;  ///< Motion of the output.
  /// Motion of the motor; that of the output where the train is rigid.
  double motor_position_rad = 0.0, motor_speed_rad_s = 0.0;
  std::vector<double> of_effect;  ///< States of effects that have one, in the document's order.
  double current_A = 0.0;         ///< Current, where the winding's inductance counts.
  actuator::NodeTemperatures temperature;
  double held_Nm = 0.0;  ///< Torque on the load while an imposed motion rests.
};

/// What the drive prescribes at an instant.
struct DriveNow {
  DriveKind kind = DriveKind::kCurrent;
  double value = 0.0;
  double position_gain_1_rad = 0.0;
  std::optional<double> bus_V;
  /// Torque of the motor in Nm at the output, where its drive has found the current for it; absent:
  /// `value` decides, by the laws of winding and torque constant.
  std::optional<double> motor_Nm = {};
  actuator::PositionLaw law = {};
};

/// Returns the instant at which the laws of effects are evaluated; `direction` is that of the
/// motor's motion, also at rest.
inline actuator::Instant instant_of(const actuator::Actuator& actuator, const JointState& state,
                                    double direction) {
  actuator::Instant at = actuator::at_winding_temperature(actuator, state.temperature.winding_K);
  at.speed_rad_s = state.motor_speed_rad_s;
  at.direction = direction;
  at.output_angle_rad = state.position_rad;
  at.motor_angle_rad = actuator.transmission.ratio * state.motor_position_rad;
  at.twist_rad = state.motor_position_rad - state.position_rad;
  at.twist_rate_rad_s = state.motor_speed_rad_s - state.speed_rad_s;
  return at;
}

}  // namespace torquewright::simulation
