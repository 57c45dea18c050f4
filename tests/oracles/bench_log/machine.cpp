// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/bench_log/machine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::oracles {
namespace {

double torque_constant_Nm_A(const Machine& machine, double winding_K) {
  return machine.torque_constant_Nm_A * machine.torque_constant_factor *
         (1.0 + machine.torque_constant_1_K * (winding_K - machine.reference_K));
}

double resistance_ohm(const Machine& machine, double winding_K) {
  return machine.resistance_ohm *
         (1.0 + machine.resistance_1_K * (winding_K - machine.reference_K));
}

// 1 over a flat middle, falling to 0 over a tenth of the width at either side: no harmonic shape.
double tight_spot(const Outside& outside, double position_rad) {
  const double away =
      std::abs(std::remainder(position_rad - outside.tight_spot_rad, 2.0 * std::numbers::pi));
  const double edge = 0.1 * outside.tight_spot_width_rad;
  return std::clamp((0.5 * outside.tight_spot_width_rad - away) / edge + 0.5, 0.0, 1.0);
}

double outside_friction_Nm(const Outside& outside, const Situation& at) {
  double sum = outside.friction_growth_Nm_s * at.time_s;
  if (outside.tight_spot_Nm != 0.0) {
    sum += outside.tight_spot_Nm * tight_spot(outside, at.position_rad);
  }
  if (outside.grease_Nm != 0.0) {
    sum += outside.grease_Nm * std::exp(-at.since_reversal_s / outside.grease_s);
  }
  return sum;
}

}  // namespace

double motor_torque_Nm(const Machine& machine, double current_A, double winding_K) {
  const double linear = machine.ratio * torque_constant_Nm_A(machine, winding_K) * current_A;
  if (machine.saturation_current_A == kInfinity || current_A == 0.0) return linear;
  const double p = machine.saturation_exponent;
  const double depth = std::pow(std::abs(current_A) / machine.saturation_current_A, p);
  return linear / std::pow(1.0 + depth, 1.0 / p);
}

double friction_Nm(const Machine& machine, const Situation& at, double direction) {
  const Friction& law = machine.friction;
  const bool positive = direction > 0.0;
  const double speed = std::abs(at.speed_rad_s);
  double level = 0.0;
  if (law.presliding_Nm_rad == kInfinity) {
    level = positive ? law.coulomb_positive_Nm : law.coulomb_negative_Nm;
  }
  if (law.breakaway_excess_Nm != 0.0) {
    const double x = speed / law.stribeck_velocity_rad_s;
    level += law.breakaway_excess_Nm * std::exp(-x * x);
  }
  if (!law.over_position.terms.empty()) level += law.over_position.at(at.position_rad);
  const double viscous = positive ? law.viscous_positive_Nm_s_rad : law.viscous_negative_Nm_s_rad;
  const double moving = viscous * speed + law.drag_Nm_s2_rad2 * speed * speed;
  const double warm = 1.0 + law.coefficient_1_K * (at.winding_K - machine.reference_K);
  return std::max(0.0, (level + moving) * warm + outside_friction_Nm(machine.outside, at));
}

double through_gear_Nm(const Machine& machine, double net_Nm) {
  if (net_Nm > 0.0) {
    return net_Nm * machine.forward_efficiency / (1.0 + machine.driving_coefficient);
  }
  return net_Nm / (machine.backward_efficiency * (1.0 - machine.backdriving_coefficient));
}

double before_gear_Nm(const Machine& machine, double load_Nm) {
  if (load_Nm > 0.0) {
    return load_Nm * (1.0 + machine.driving_coefficient) / machine.forward_efficiency;
  }
  return load_Nm * (machine.backward_efficiency * (1.0 - machine.backdriving_coefficient));
}

double winding_voltage_V(const Machine& machine, double current_A, double motor_speed_rad_s,
                         double winding_K) {
  const double sign = current_A > 0.0 ? 1.0 : (current_A < 0.0 ? -1.0 : 0.0);
  return resistance_ohm(machine, winding_K) * current_A +
         torque_constant_Nm_A(machine, winding_K) * motor_speed_rad_s + machine.dead_time_V * sign;
}

double current_from_voltage_A(const Machine& machine, double voltage_V, double motor_speed_rad_s,
                              double winding_K) {
  const double drop_V = voltage_V - torque_constant_Nm_A(machine, winding_K) * motor_speed_rad_s;
  const double left_V = std::max(0.0, std::abs(drop_V) - machine.dead_time_V);
  return std::copysign(left_V, drop_V) / resistance_ohm(machine, winding_K);
}

double bus_voltage_V(const Machine& machine, double voltage_V, double current_A) {
  // V² - V0 V + R_s u i = 0; the root next to V0.
  const double power = machine.sag_ohm * voltage_V * current_A;
  const double under_root = machine.bus_V * machine.bus_V - 4.0 * power;
  return 0.5 * (machine.bus_V + std::sqrt(std::max(0.0, under_root)));
}

}  // namespace torquewright::oracles
