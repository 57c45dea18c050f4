// SPDX-License-Identifier: Apache-2.0
#include "simulation/joint/joint_state.hpp"

#include "actuator/heat/temperature_laws.hpp"

namespace torquewright::simulation {

actuator::Instant instant_of(const actuator::Actuator& actuator, const JointState& state,
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
