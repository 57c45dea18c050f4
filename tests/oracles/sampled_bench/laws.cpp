// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/laws.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::sampled {
namespace {

double warmth(double coefficient_1_K, double temperature_K) {
  return std::max(0.05, 1.0 + coefficient_1_K * (temperature_K - kReference_K));
}

}  // namespace

double sum_at(const std::vector<Harmonic>& harmonics, double angle_rad) {
  double sum = 0.0;
  for (const Harmonic& one : harmonics) {
    sum += one.amplitude * std::sin(one.order * angle_rad + one.phase_rad);
  }
  return sum;
}

double constant_Nm_A(const Plant& plant, const Laws& laws, double winding_K) {
  return plant.Nm_per_A() * laws.constant_factor * warmth(laws.constant_temperature_1_K, winding_K);
}

double magnet_torque_Nm(const Plant& plant, const Laws& laws, double current_A, double winding_K) {
  double effective_A = current_A;
  if (laws.saturation_current_A > 0.0) {
    const double p = laws.saturation_exponent;
    const double share = std::abs(current_A) / laws.saturation_current_A;
    effective_A /= std::pow(1.0 + std::pow(share, p), 1.0 / p);
  }
  return constant_Nm_A(plant, laws, winding_K) * effective_A;
}

double dry_friction_Nm(const Laws& laws, const Instant& at, double speed_rad_s, double sign) {
  double level = sign > 0.0 ? laws.coulomb_positive_Nm : laws.coulomb_negative_Nm;
  if (laws.breakaway_excess_Nm != 0.0) {
    const double share = speed_rad_s / laws.stribeck_velocity_rad_s;
    level += laws.breakaway_excess_Nm * std::exp(-share * share);
  }
  if (!laws.tight_spots.empty()) level += sum_at(laws.tight_spots, at.angle_rad);
  level *= 1.0 + laws.odd.friction_growth_1_s * at.time_s;
  if (laws.odd.lubrication_Nm > 0.0) {
    level *= std::exp(-std::abs(at.torque_Nm) / laws.odd.lubrication_Nm);
  }
  level += laws.odd.iron_loss_Nm_A2 * at.current_A * at.current_A;
  return std::max(0.0, level) * warmth(laws.friction_temperature_1_K, at.winding_K);
}

double wet_friction_Nm(const Laws& laws, const Instant& at, double speed_rad_s) {
  const double viscous =
      speed_rad_s > 0.0 ? laws.viscous_positive_Nm_s_rad : laws.viscous_negative_Nm_s_rad;
  return (viscous + laws.quadratic_Nm_s2_rad2 * std::abs(speed_rad_s)) * speed_rad_s *
         warmth(laws.friction_temperature_1_K, at.winding_K);
}

double through_mesh_Nm(const Plant& plant, const Laws& laws, double torque_Nm, double sign) {
  if (torque_Nm * sign > 0.0) {
    return torque_Nm * plant.forward_efficiency / (1.0 + laws.driving_coefficient);
  }
  return torque_Nm / (plant.backward_efficiency * (1.0 - laws.backdriving_coefficient));
}

double output_torques_Nm(const Laws& laws, const Instant& at, double mesh_Nm) {
  const Oddities& odd = laws.odd;
  double torque =
      sum_at(laws.ripple, at.angle_rad) + mesh_Nm * sum_at(laws.proportional_ripple, at.angle_rad);
  if (laws.imbalance.amplitude != 0.0) torque += sum_at({laws.imbalance}, at.angle_rad);
  torque -= odd.spring_Nm_rad * (at.angle_rad - odd.spring_rest_rad);
  torque -= odd.stop_Nm_rad * std::max(0.0, at.angle_rad - odd.stop_rad);
  if (odd.hysteresis_Nm > 0.0) torque -= at.hysteresis_Nm;
  return torque;
}

double load_torque_Nm(const Plant& plant, const Laws& laws, const Instant& at) {
  if (plant.load.kind == LoadKind::kImposedSpeed) return at.torque_Nm;
  const Load& load = plant.load;
  const double mass_kg = load.mass_kg * laws.load_mass_factor;
  const double inertia =
      load.inertia_kg_m2 * laws.load_inertia_factor + mass_kg * load.length_m * load.length_m;
  const double gravity = mass_kg * kGravity_m_s2 * load.length_m * std::sin(at.angle_rad);
  return inertia * at.acceleration_rad_s2 + gravity - at.brake_Nm;
}

double current_of_voltage_A(const Plant& plant, const Laws& laws, const Instant& at) {
  const double back_emf_V = constant_Nm_A(plant, laws, at.winding_K) * at.motor_speed_rad_s;
  const double resistance =
      plant.resistance_ohm * warmth(laws.resistance_temperature_1_K, at.winding_K);
  const double driving_V = at.winding_V - back_emf_V - plant.inductance_H * at.current_rate_A_s;
  return beyond(driving_V, laws.dead_time_V) / resistance;
}

double predicted_torque_Nm(const Plant& plant, const Laws& laws, const Instant& at) {
  double current_A = laws.lag_s > 0.0 ? at.torque_current_A : at.current_A;
  if (plant.is_voltage_driven()) current_A = current_of_voltage_A(plant, laws, at);
  const double speed = at.motor_speed_rad_s;
  const double sign = sign_of(speed);
  const double dry =
      laws.presliding_Nm_rad > 0.0 ? at.bristle_Nm : sign * dry_friction_Nm(laws, at, speed, sign);
  const double before =
      magnet_torque_Nm(plant, laws, current_A, at.winding_K) +
      sum_at(laws.cogging, plant.ratio * at.motor_angle_rad) -
      (plant.armature_kg_m2() + laws.inertia_kg_m2) * at.motor_acceleration_rad_s2 - dry -
      wet_friction_Nm(laws, at, speed);
  const double mesh = through_mesh_Nm(plant, laws, before, sign);
  return mesh + output_torques_Nm(laws, at, mesh);
}

}  // namespace torquewright::oracles::sampled
