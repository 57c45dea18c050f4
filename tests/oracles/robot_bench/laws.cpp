// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/laws.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::robot_bench {

double Laws::dry_Nm(double speed_rad_s, bool forwards, double gear_torque_Nm) const {
  const double part = speed_rad_s / stribeck_velocity_rad_s;
  const bool drives = (gear_torque_Nm > 0) == forwards;
  return coulomb_Nm[forwards ? 0 : 1] + breakaway_excess_Nm * std::exp(-part * part) +
         (drives ? driving_coefficient : backdriving_coefficient) * std::abs(gear_torque_Nm);
}

double Laws::stops_Nm(double position_rad) const {
  return -upper.stiffness_Nm_rad * std::max(0.0, position_rad - upper.angle_rad) +
         lower.stiffness_Nm_rad * std::max(0.0, lower.angle_rad - position_rad);
}

double Laws::spring_and_ripple_Nm(double position_rad) const {
  double torque = -spring_Nm_rad * (position_rad - spring_neutral_rad);
  for (const Harmonic& one : ripple)
    torque += one.amplitude_Nm * std::sin(one.order * position_rad + one.phase_rad);
  return torque;
}

double Controller::torque_Nm(double command_rad, double position_rad, double speed_rad_s) const {
  const double torque =
      stiffness_Nm_rad * (command_rad - position_rad) - damping_Nm_s_rad * speed_rad_s;
  return std::clamp(torque, -torque_limit_Nm, torque_limit_Nm);
}

}  // namespace torquewright::oracles::robot_bench
