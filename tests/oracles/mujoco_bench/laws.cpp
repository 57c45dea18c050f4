// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/laws.hpp"

#include <cmath>

namespace torquewright::oracles::mujoco_bench {

double sum_of(const std::vector<Harmonic>& harmonics, double angle_rad) {
  double sum = 0;
  for (const Harmonic& one : harmonics)
    sum += one.amplitude * std::sin(one.order * angle_rad + one.phase_rad);
  return sum;
}

double magnet_factor(const World& world, double temperature_K) {
  return 1 + world.laws.magnet_1_K * (temperature_K - world.motor.reference_temperature_K);
}

double resistance_ohm(const World& world, double temperature_K) {
  const double warmer_K = temperature_K - world.motor.reference_temperature_K;
  return world.motor.resistance_ohm * (1 + world.laws.copper_1_K * warmer_K);
}

double motor_torque_Nm(const World& world, double current_A, double temperature_K) {
  const Laws& laws = world.laws;
  double torque = world.motor.gain_Nm_A() * current_A * laws.torque_constant_factor *
                  magnet_factor(world, temperature_K);
  if (laws.saturation_current_A < kNever) {
    const double p = laws.saturation_exponent;
    torque /= std::pow(1 + std::pow(std::abs(current_A) / laws.saturation_current_A, p), 1 / p);
  }
  return torque;
}

double drag_Nm(const World& world, const Sliding& at, double direction) {
  const Laws& laws = world.laws;
  const int side = direction > 0 ? 0 : 1;
  const double speed = std::abs(at.speed_rad_s);
  double drag = laws.coulomb_Nm[side] + laws.viscous_Nm_s_rad[side] * speed +
                laws.drag_Nm_s2_rad2 * speed * speed + sum_of(laws.tight_spots, at.position_rad);
  if (laws.breakaway_excess_Nm > 0) {
    const double part = speed / laws.stribeck_velocity_rad_s;
    drag += laws.breakaway_excess_Nm * std::exp(-part * part);
  }
  drag += laws.iron_loss_Nm_A2 * at.current_A * at.current_A + laws.growth_Nm_s * at.time_s;
  drag += laws.fading_Nm / (1 + std::abs(at.load_Nm) / laws.fading_load_Nm);
  return drag * (1 + laws.grease_1_K * (at.temperature_K - world.motor.reference_temperature_K));
}

double mesh_gain(const World& world, double mesh_torque_Nm, double direction) {
  const bool drives = mesh_torque_Nm * direction > 0;
  return drives ? (1 + world.laws.driving_coefficient) / world.motor.forward_efficiency
                : world.motor.backward_efficiency * (1 - world.laws.backdriving_coefficient);
}

double dahl_Nm(double force_Nm, double displacement_rad, double level_Nm, double stiffness_Nm_rad) {
  const double end = displacement_rad > 0 ? level_Nm : -level_Nm;
  const double passed = stiffness_Nm_rad * std::abs(displacement_rad) / level_Nm;
  return end + (force_Nm - end) * std::exp(-passed);
}

double flange_torque_Nm(const World& world, double position_rad) {
  const Load& load = world.load;
  return sum_of(world.laws.ripple, position_rad) +
         load.imbalance_Nm * std::sin(position_rad + load.imbalance_phase_rad);
}

double load_ripple_factor(const World& world, double position_rad) {
  return 1 + sum_of(world.laws.load_ripple, position_rad);
}

}  // namespace torquewright::oracles::mujoco_bench
